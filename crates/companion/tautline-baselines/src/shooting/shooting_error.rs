//! `ShootingError`: the reason why there is no shot.

use tautline::SetError;

use crate::{EquationError, not_finite::NotFinite};

/// The reason why there is no geodesic by shooting.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShootingError {
    /// A coordinate of a point or of a velocity is NaN or infinite.
    #[error("coordinate {coordinate} of the {what} is {value}: it must be finite")]
    NotFinite {
        /// What the coordinate belongs to.
        what: &'static str,
        /// The index of the coordinate, from 0.
        coordinate: usize,
        /// The coordinate.
        value: f64,
    },
    /// Two points make no pair of ends, as where their coordinates are too large.
    #[error(transparent)]
    Ends(#[from] SetError),
    /// The tolerance of the integration is not between `10⁻¹⁴` and `10⁻²`.
    #[error("the tolerance is {tolerance}: it must be between 1e-14 and 1e-2")]
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The shot reaches a point where the metric makes no geodesic equation.
    #[error("the shot leaves the domain of the metric after the time {time}")]
    LeavesTheDomain {
        /// The last time in `[0, 1]` that the shot reaches.
        time: f64,
        /// The reason, at a point just beyond.
        source: EquationError,
    },
    /// The integration needs steps below rounding, as for a geodesic that ends in finite time.
    #[error("at the time {time} a step of {step} is too long for the tolerance")]
    StepTooSmall {
        /// The last time in `[0, 1]` that the shot reaches.
        time: f64,
        /// The length of the step.
        step: f64,
    },
    /// The integration needs more steps than the options allow.
    #[error("the shot has not arrived after {steps} steps, at the time {time}")]
    TooManySteps {
        /// The allowed number of steps.
        steps: usize,
        /// The time in `[0, 1]` that the shot reached.
        time: f64,
    },
    /// The energy is beyond the range of `f64`.
    #[error("the energy is {energy}: the coordinates or the metric are out of range for f64")]
    Energy {
        /// The energy at an end, in `m²`: infinite, or less than the least normal number although
        /// the velocity is not zero.
        energy: f64,
    },
    /// Newton's method found no shot that ends on the target.
    #[error("after {iterations} Newton steps the shot misses by {residual}")]
    NoConvergence {
        /// The distance between the end of the best shot and its target, in `ℓ`.
        residual: f64,
        /// The number of Newton steps.
        iterations: usize,
    },
}

impl From<NotFinite> for ShootingError {
    fn from(NotFinite { what, coordinate, value }: NotFinite) -> Self {
        Self::NotFinite { what, coordinate, value }
    }
}
