//! `Known`: a problem with a known distance.

use nalgebra::SVector;
use tautline::{Bounded, Ends, KnownDistance, SetError, bounds::Setting};

use crate::{AnyBounded, VerifyError};

/// A metric, two sets, and the distance between them.
#[derive(Clone, Debug)]
pub struct Known<M, const D: usize> {
    /// The metric.
    pub metric: M,
    /// The two sets.
    pub ends: Ends<D>,
    /// Their distance `d`, in `m`.
    pub distance: f64,
    /// The error of `distance`, in `m`: the rounding of a closed form, or the error of an estimate.
    pub distance_error: f64,
}

impl<M, const D: usize> Known<M, D> {
    /// Returns the error of `distance²`, in `m²`.
    pub(crate) fn squared_error(&self) -> f64 {
        2.0 * self.distance * self.distance_error
    }
}

impl<M: Bounded<D>, const D: usize> Known<M, D> {
    /// Returns the problem between two points; `None` if the metric does not know their distance.
    ///
    /// A closed form is a difference of numbers up to `√c₂ (|a| + |b|)`, with about four roundings
    /// each. Hence `distance_error` is `16 ε` times this size.
    ///
    /// # Errors
    ///
    /// [`SetError`] if a coordinate is not finite.
    pub fn between(
        metric: M,
        a: impl Into<SVector<f64, D>>,
        b: impl Into<SVector<f64, D>>,
    ) -> Result<Option<Self>, SetError>
    where
        M: KnownDistance<D>,
    {
        let (a, b) = (a.into(), b.into());
        let ends = Ends::points(a, b)?;
        let Some(distance) = metric.distance(&a, &b) else { return Ok(None) };
        let size = (a.norm() + b.norm()) * metric.constants().c2().sqrt();
        Ok(Some(Self { metric, ends, distance, distance_error: 16.0 * f64::EPSILON * size }))
    }

    /// Returns the same problem with the metric behind a pointer.
    #[must_use]
    pub fn behind_a_pointer(&self) -> Known<AnyBounded<'_, D>, D> {
        let Self { ref metric, ref ends, distance, distance_error } = *self;
        Known { metric: AnyBounded::of(metric), ends: ends.clone(), distance, distance_error }
    }

    /// Returns the constants, the distance and the dimension, from which the theorems compute their
    /// bounds.
    ///
    /// # Errors
    ///
    /// [`VerifyError::Bound`] if the distance is negative or not finite.
    pub fn setting(&self) -> Result<Setting, VerifyError> {
        Ok(Setting::new(self.metric.constants(), self.distance, D)?)
    }
}
