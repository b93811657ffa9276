//! `CollocationError`: the reason why there is no path by collocation.

use crate::{EquationError, not_finite::NotFinite};

/// The reason why there is no geodesic by collocation.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CollocationError {
    /// A coordinate of an end is NaN or infinite.
    #[error("coordinate {coordinate} of the {what} is {value}: it must be finite")]
    NotFinite {
        /// What the coordinate belongs to.
        what: &'static str,
        /// The index of the coordinate, from 0.
        coordinate: usize,
        /// The coordinate.
        value: f64,
    },
    /// The tolerance is not between `10⁻¹⁰` and `10⁻¹`.
    #[error("the tolerance is {tolerance}: it must be between 1e-10 and 1e-1")]
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The first mesh has no interval.
    #[error("the first mesh has no interval")]
    NoIntervals,
    /// The metric makes no geodesic equation somewhere along the start.
    #[error("the start leaves the domain of the metric")]
    LeavesTheDomain(#[from] EquationError),
    /// The energy is beyond the range of `f64`.
    #[error("the energy is {energy}: the coordinates or the metric are out of range for f64")]
    Energy {
        /// The energy, in `m²`: infinite, or less than the least normal number although the ends
        /// differ.
        energy: f64,
    },
    /// Newton's method did not converge on a mesh.
    #[error(
        "{iterations} Newton steps on {intervals} intervals leave a correction of {correction}"
    )]
    NoConvergence {
        /// The number of intervals of the mesh.
        intervals: usize,
        /// The size of the last correction, relative to that of the curve. It is NaN or
        /// infinite if the equations are singular.
        correction: f64,
        /// The number of Newton steps on this mesh.
        iterations: usize,
    },
    /// The tolerance needs more intervals than the options allow.
    #[error("{intervals} intervals leave a residual of {residual}, and more are not allowed")]
    TooManyIntervals {
        /// The number of intervals of the last mesh.
        intervals: usize,
        /// Its largest residual, relative to the speed.
        residual: f64,
    },
}

impl From<NotFinite> for CollocationError {
    fn from(NotFinite { what, coordinate, value }: NotFinite) -> Self {
        Self::NotFinite { what, coordinate, value }
    }
}
