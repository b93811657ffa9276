//! `SolveError`: why no minimiser was searched, or none could be.

use tautline_discretizations::{LARGEST_N, SequenceError};
use tautline_metrics::MetricError;

/// Why there is no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// `N = 0`.
    #[error("N = 0: a point sequence has at least one subinterval")]
    NoSubinterval,
    /// More than [`LARGEST_N`] subintervals.
    #[error(
        "N = {n} is too many subintervals: beyond {} rounding outweighs what they gain",
        LARGEST_N
    )]
    TooManySubintervals {
        /// The number of subintervals.
        n: usize,
    },
    /// The system has no memory for a grid on the way to the result, or for the result.
    #[error("N = {n}: there is no memory for the {bytes} bytes that this grid takes")]
    OutOfMemory {
        /// The number of subintervals of the grid.
        n: usize,
        /// What its points or a Newton step on it would take.
        bytes: usize,
    },
    /// The metric is not one along the curves that were tried.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// A point sequence became infinite on the way to a finer grid.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// The discrete energy of what was found is beyond the range of `f64`.
    #[error("the energy is {energy}: the coordinates or the metric are too large for f64")]
    Energy {
        /// The energy, in `m²`: infinite, or NaN for a difference of infinite numbers.
        energy: f64,
    },
    /// There was no sequence to start from: none was given, or none has finite points.
    #[error("no sequence of finite points to start from")]
    NoStart,
}
