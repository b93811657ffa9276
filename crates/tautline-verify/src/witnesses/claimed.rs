//! `Claimed`: a metric that is said to have constants which may not be its own.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, KnownDistance, Metric, Scalar};

/// A metric, and constants that someone claims for it: for showing that a statement fails where
/// its hypotheses on `c₁`, `c₂` and `L_H` do, and that the evidence tells so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claimed<M> {
    metric: M,
    constants: Constants,
}

impl<M> Claimed<M> {
    /// Returns the metric with these constants, true or not.
    pub fn new(metric: M, constants: Constants) -> Self {
        Self { metric, constants }
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for Claimed<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for Claimed<M> {
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<M: KnownDistance<D>, const D: usize> KnownDistance<D> for Claimed<M> {
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        self.metric.distance(x, y)
    }
}
