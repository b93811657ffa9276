//! `CalculusError`: the reason why a step of the discrete calculus has no result.

use tautline::{SequenceError, SetError, SolveError};

use crate::{EquationError, not_finite::NotFinite};

/// The reason why the discrete geodesic calculus has no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CalculusError {
    /// A coordinate of a point or of a vector is NaN or infinite.
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
    /// The number of chords is 0, or too large for a sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// There is no discrete geodesic between the points.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The metric has no Gram matrix, or no derivatives, in the middle of a chord.
    #[error("step {step} leaves the domain of the metric")]
    LeavesTheDomain {
        /// The number of the chord, from 0.
        step: usize,
        /// The reason.
        source: EquationError,
    },
    /// The equation of a step was not solved.
    #[error("step {step} was not solved: the last correction is {correction}")]
    NoConvergence {
        /// The number of the chord, from 0.
        step: usize,
        /// The length of the last Newton step, in `ℓ`.
        correction: f64,
    },
}

impl From<NotFinite> for CalculusError {
    fn from(NotFinite { what, coordinate, value }: NotFinite) -> Self {
        Self::NotFinite { what, coordinate, value }
    }
}
