//! A metric with another unit of length: `s H`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::CompositionError;
use crate::{
    Bounded, Constants, HypothesisError, KnownDistance, LocalError, LocallyBounded, Metric,
};

/// `s H(x)`, which has the same geodesics as `H`, with all lengths multiplied by `√s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled<M> {
    metric: M,
    factor: f64,
}

impl<M> Scaled<M> {
    /// Returns the metric `s H` for a factor `s > 0`.
    ///
    /// # Errors
    ///
    /// [`HypothesisError::NotAFactor`] unless `s` is positive and finite.
    pub fn new(metric: M, factor: f64) -> Result<Self, CompositionError> {
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(HypothesisError::NotAFactor { factor }.into());
        }
        Ok(Self { metric, factor })
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for Scaled<M> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x).map(|entry| entry * self.factor)
    }
}

impl<M: Bounded<D>, const D: usize> Bounded<D> for Scaled<M> {
    /// Returns the constants of `H`, multiplied by `s` ([`Constants::scaled`]).
    ///
    /// # Panics
    ///
    /// If a constant overflows, or if `c₁` underflows.
    fn constants(&self) -> Constants {
        self.metric.constants().scaled(self.factor).expect("a factor within the range of f64")
    }
}

impl<M: LocallyBounded<D>, const D: usize> LocallyBounded<D> for Scaled<M> {
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        Ok(self.metric.constants_within(centre, radius)?.scaled(self.factor)?)
    }
}

impl<M: KnownDistance<D>, const D: usize> KnownDistance<D> for Scaled<M> {
    /// Returns `√s` times the distance in the metric `H`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        self.metric.distance(x, y).map(|distance| distance * self.factor.sqrt())
    }
}
