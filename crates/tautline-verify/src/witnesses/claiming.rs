//! `Claiming`: a metric that claims constants which are not its own.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// A metric, and the constants that it is to claim, true or not: what a statement says where one of
/// its hypotheses on `c₁`, `c₂` and `L_H` is dropped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claiming<M> {
    /// The metric.
    pub metric: M,
    /// What it claims.
    pub constants: Constants,
}

impl<M: Metric<D>, const D: usize> Metric<D> for Claiming<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for Claiming<M> {
    /// What is claimed.
    fn constants(&self) -> Constants {
        self.constants
    }
}
