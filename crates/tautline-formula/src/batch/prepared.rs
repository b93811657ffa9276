//! `Prepared`: a metric by batches, in the way that is fastest for it.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{
    Formula,
    batch::{Batches, Kind, Layout, Plain, Programs},
    program::Registers,
};

/// A metric, ready to be evaluated at many places: by the programs of its formula, where it can be recorded
/// and is not too long; by the formula as it is compiled elsewhere.
#[derive(Debug)]
pub struct Prepared<M, const D: usize> {
    plain: Plain<M, D>,
    programs: Option<Programs<D>>,
}

/// The longest formula that is differentiated.
const LONGEST: usize = 1 << 14;

impl<M: Metric<D>, const D: usize> Prepared<M, D> {
    /// Records the formula of a metric, if that is possible.
    #[must_use]
    pub fn new(metric: M) -> Self {
        let formula = Formula::record(&metric).ok();
        let formula = formula.filter(|formula| formula.operations().len() <= LONGEST);
        Self { plain: Plain::new(metric), programs: formula.map(Programs::new) }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        self.plain.metric()
    }

    /// Returns the programs of its formula, if it has some.
    #[must_use]
    pub fn programs(&self) -> Option<&Programs<D>> {
        self.programs.as_ref()
    }

    fn way(&self) -> &dyn Batches<D> {
        match &self.programs {
            Some(programs) => programs,
            None => &self.plain,
        }
    }
}

impl<M: Metric<D>, const D: usize> Batches<D> for Prepared<M, D> {
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        self.plain.gram(x)
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.way().layout(kind)
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.way().registers(kind, unit, units)
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        self.way().evaluate(kind, registers);
    }
}
