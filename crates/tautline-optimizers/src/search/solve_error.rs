//! `SolveError`: why no minimiser was searched, or none could be.

use tautline_discretizations::SequenceError;
use tautline_metrics::MetricError;

/// Why there is no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// `N = 0`.
    #[error("N = 0: a point sequence has at least one subinterval")]
    NoSubinterval,
    /// More subintervals than any memory has room for.
    #[error("N = {n}: no memory has room for so many points")]
    TooManySubintervals {
        /// The number of subintervals.
        n: usize,
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
