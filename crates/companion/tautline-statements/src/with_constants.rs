//! `WithConstants`: a metric with claimed constants, true or not.

use nalgebra::{SMatrix, SVector};
use tautline::{AnyMetric, Bounded, Constants, KnownDistance, Metric, Scalar};

/// A metric with claimed constants, true or not. It serves for a metric without constants of its
/// own, for false claims that a test must reject, and for statements whose hypotheses on `c₁`, `c₂`
/// and `L_H` fail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithConstants<M> {
    /// The metric.
    pub metric: M,
    /// The claimed constants.
    pub constants: Constants,
}

/// A metric behind a pointer, with its constants. Code for it is compiled once for each dimension.
pub type AnyBounded<'m, const D: usize> = WithConstants<AnyMetric<'m, D>>;

impl<'m, const D: usize> AnyBounded<'m, D> {
    /// Returns a pointer to a metric.
    #[must_use]
    pub fn of(metric: &'m impl Bounded<D>) -> Self {
        Self { metric: AnyMetric::new(metric), constants: metric.constants() }
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for WithConstants<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for WithConstants<M> {
    /// The claimed constants.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<M: KnownDistance<D>, const D: usize> KnownDistance<D> for WithConstants<M> {
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        self.metric.distance(x, y)
    }
}
