//! `Prepared`: batches evaluated in the fastest way for a metric.

use std::sync::OnceLock;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{
    BlackBox, BlackBoxBatches, Formula,
    batch::{Batches, Kind, Layout, Plain, kernel::Kernel},
    program::{InstructionSet, Registers},
};

/// A metric, ready to be evaluated at many points at once.
///
/// It runs programs that are derived from the formula on first use. A formula that compares numbers
/// cannot be recorded, and the programs of a very long formula are slow. Such formulas are
/// evaluated as compiled, point by point. The results agree up to rounding.
#[derive(Debug)]
pub struct Prepared<M, const D: usize> {
    plain: Plain<M, D>,
    formula: Option<Formula<D>>,
    kernels: [OnceLock<Option<Kernel>>; 4],
    instruction_set: InstructionSet,
    lanes: usize,
    /// The metric, if it is known by its values only.
    black_box: Option<BlackBoxBatches<D>>,
}

/// The greatest number of lanes.
const LANES: usize = 128;

impl<M: Metric<D>, const D: usize> Prepared<M, D> {
    /// Records the formula of a metric.
    #[must_use]
    pub fn new(metric: M) -> Self {
        Self::with(metric, InstructionSet::Widest, LANES)
    }

    /// Does the same with this instruction set and at most this many lanes. There are fewer lanes
    /// if they would not fit into a cache. The results are the same bit for bit.
    #[must_use]
    pub fn with(metric: M, instruction_set: InstructionSet, lanes: usize) -> Self {
        let formula = Formula::record(&metric).ok();
        let (plain, kernels) = (Plain::new(metric), Default::default());
        Self { plain, formula, kernels, instruction_set, lanes, black_box: None }
    }

    /// Wraps a metric that computes what a black box does. Batches are evaluated by the latter, all
    /// points of a batch in one call.
    #[must_use]
    pub fn of_black_box(metric: M, black_box: BlackBox<D>) -> Self {
        Self {
            plain: Plain::new(metric),
            formula: None,
            kernels: Default::default(),
            instruction_set: InstructionSet::Widest,
            lanes: LANES,
            black_box: Some(BlackBoxBatches::new(black_box)),
        }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        self.plain.metric()
    }

    /// Returns the metric's formula, or `None` if it could not be recorded.
    #[must_use]
    pub fn formula(&self) -> Option<&Formula<D>> {
        self.formula.as_ref()
    }

    /// Returns the numbers of instructions and registers of a program, or `None` if there is none.
    #[must_use]
    pub fn size(&self, kind: Kind) -> Option<[usize; 2]> {
        self.kernel(kind).map(Kernel::size)
    }

    /// Returns what evaluates the batches that no program evaluates.
    fn otherwise(&self) -> &dyn Batches<D> {
        self.black_box.as_ref().map_or(&self.plain, |black_box| black_box)
    }

    fn kernel(&self, kind: Kind) -> Option<&Kernel> {
        let derive = || Kernel::new(self.formula.as_ref()?.tape(), kind);
        self.kernels[kind as usize].get_or_init(derive).as_ref()
    }
}

impl<M: Metric<D>, const D: usize> Batches<D> for Prepared<M, D> {
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        self.plain.gram(x)
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.kernel(kind).map_or_else(|| self.otherwise().layout(kind), Kernel::layout)
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        let Some(kernel) = self.kernel(kind) else {
            return self.otherwise().registers(kind, unit, units);
        };
        let lanes = unit.saturating_mul(units).min(self.lanes).min(kernel.lanes()).max(unit);
        Registers::new(kernel.program(), lanes, self.instruction_set)
    }

    fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        match self.kernel(kind) {
            Some(kernel) => registers.run(kernel.program()),
            None => self.otherwise().evaluate(kind, registers),
        }
    }
}
