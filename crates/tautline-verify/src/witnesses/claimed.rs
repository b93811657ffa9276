//! `Claimed`: a metric with constants that are only claimed of it.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// A metric with constants that may be false: what is left of a statement without a hypothesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claimed<M> {
    /// The metric.
    pub metric: M,
    /// What is claimed of it.
    pub constants: Constants,
}

impl<M: Metric<D>, const D: usize> Metric<D> for Claimed<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for Claimed<M> {
    /// Those that are claimed.
    fn constants(&self) -> Constants {
        self.constants
    }
}
