//! `BatchesIn`: batches of a metric whose dimension is a value, as batches on `R^D`.

use crate::{
    batch::{AnyBatches, Batches, Kind, Layout},
    program::{InstructionSet, Registers},
};

/// Batches of a metric whose dimension is a value, as batches on `R^D`.
pub struct BatchesIn<'m, const D: usize>(&'m dyn AnyBatches);

impl<'m, const D: usize> BatchesIn<'m, D> {
    /// Takes a metric; `None` if it is one in another dimension.
    #[must_use]
    pub fn new(metric: &'m dyn AnyBatches) -> Option<Self> {
        (metric.dimension() == D).then_some(Self(metric))
    }
}

impl<const D: usize> Batches<D> for BatchesIn<'_, D> {}

impl<const D: usize> AnyBatches for BatchesIn<'_, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn quadrature_tolerance(&self) -> f64 {
        self.0.quadrature_tolerance()
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.0.gram_into(x, gram);
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.0.layout(kind)
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.0.registers(kind, unit, units)
    }

    fn instruction_set(&self) -> InstructionSet {
        self.0.instruction_set()
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        self.0.evaluate(kind, registers);
    }
}
