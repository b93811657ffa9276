//! `ConstrainedError`: why there is no constrained descent.

use crate::descent::DescentError;

/// Why there is no constrained descent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConstrainedError {
    /// The start has no metric or no energy, or the tolerance is negative or not a number.
    #[error(transparent)]
    Descent(#[from] DescentError),
    /// The feasibility is negative or not a number.
    #[error("the largest violation is {feasibility}; expected a number from 0 on")]
    Feasibility {
        /// The largest violation that is accepted.
        feasibility: f64,
    },
    /// An end of the start, which stays where it is, does not satisfy the constraint.
    #[error("the constraint is {value} at the {end} end, and not 0 up to {feasibility}")]
    End {
        /// "first" or "last".
        end: &'static str,
        /// The value of the constraint there.
        value: f64,
        /// The largest violation that is accepted.
        feasibility: f64,
    },
    /// The constraint, or the square of its gradient, is no finite number at a point of the start.
    #[error("at point {point} of the start the constraint is {value} and its slope {slope}")]
    NotFinite {
        /// The number of the point.
        point: usize,
        /// The value of the constraint there.
        value: f64,
        /// The length of its gradient.
        slope: f64,
    },
}
