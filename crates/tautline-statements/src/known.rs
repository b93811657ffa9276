//! `Known`: a problem whose distance is known.

use nalgebra::SVector;
use tautline::{Bounded, Ends, KnownDistance, SetError, bounds::Setting};

use crate::{AnyBounded, VerifyError};

/// A metric, two sets, and the distance between them: what the theorems of Section 1 compare with.
#[derive(Clone, Debug)]
pub struct Known<M, const D: usize> {
    /// The metric.
    pub metric: M,
    /// The two sets.
    pub ends: Ends<D>,
    /// Their distance `d`, in `m`.
    pub distance: f64,
    /// How far `distance` may be off, in `m`: the rounding of a closed form, or the error of an
    /// estimate.
    pub distance_error: f64,
}

impl<M: Bounded<D>, const D: usize> Known<M, D> {
    /// Two points whose distance the metric knows; `None` if it does not.
    ///
    /// The closed forms are differences of numbers that grow along the way, with some four
    /// roundings each: `distance_error` is `16 ε` times the size of these, `√c₂` times the sum of
    /// the coordinates.
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

    /// Returns the same problem, with the metric behind a pointer.
    #[must_use]
    pub fn behind_a_pointer(&self) -> Known<AnyBounded<'_, D>, D> {
        let Self { ref metric, ref ends, distance, distance_error } = *self;
        Known { metric: AnyBounded::of(metric), ends: ends.clone(), distance, distance_error }
    }

    /// Returns the numbers by which the theorems know the problem.
    ///
    /// # Errors
    ///
    /// [`VerifyError::Bound`] if the distance is no distance.
    pub fn setting(&self) -> Result<Setting, VerifyError> {
        Ok(Setting::new(self.metric.constants(), self.distance, D)?)
    }
}
