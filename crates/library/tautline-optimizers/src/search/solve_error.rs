//! `SolveError`: the reason why there is no minimiser.

use tautline_discretizations::{LARGEST_N, SequenceError};
use tautline_metrics::MetricError;

/// The reason why there is no minimiser.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// `N = 0`.
    #[error("N = 0: a point sequence has at least one subinterval")]
    NoSubinterval,
    /// There are more than [`LARGEST_N`] subintervals.
    #[error(
        "N = {n} is too many subintervals: beyond {}, rounding outweighs the gain in accuracy",
        LARGEST_N
    )]
    TooManySubintervals {
        /// The number of subintervals.
        n: usize,
    },
    /// The system has no memory for a grid on the way to the result, or for the result.
    #[error("N = {n}: no memory for the {bytes} bytes that this grid needs")]
    OutOfMemory {
        /// The number of subintervals of the grid.
        n: usize,
        /// The memory for the points of the grid or for a Newton step on it, in bytes.
        bytes: usize,
    },
    /// The metric is not finite, symmetric and positive definite along any of the curves.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// A point sequence became infinite on the way to a finer grid.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// The discrete energy of the result exceeds the range of `f64`.
    #[error("the energy is {energy}: the coordinates or the metric are too large for f64")]
    Energy {
        /// The energy, in `m²`: infinite, or NaN for a difference of infinities.
        energy: f64,
    },
    /// A set or a start lies in another dimension than the metric.
    #[error("a set or a start has {found} coordinates under a metric in dimension {metric}")]
    Dimension {
        /// The dimension of the metric.
        metric: usize,
        /// The number of coordinates.
        found: usize,
    },
    /// The watcher of the solve ended it.
    #[error("the solve was ended on its way to a minimiser, on the grid of {n} chords")]
    Interrupted {
        /// The number of chords of the grid.
        n: usize,
    },
    /// No sequence was given to start from, or none has finite points.
    #[error("no sequence of finite points to start from")]
    NoStart,
}

impl SolveError {
    /// Returns whether it is due to the number of chords: there is no such grid, or no memory for
    /// it. No other start helps then.
    #[must_use]
    pub fn is_due_to_n(&self) -> bool {
        use SolveError::{NoSubinterval, OutOfMemory, TooManySubintervals};
        matches!(self, NoSubinterval | TooManySubintervals { .. } | OutOfMemory { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::SolveError::{
        self, Energy, Interrupted, NoStart, NoSubinterval, OutOfMemory, TooManySubintervals,
    };

    #[test]
    fn three_errors_are_due_to_n() {
        let due = [NoSubinterval, TooManySubintervals { n: 9 }, OutOfMemory { n: 9, bytes: 9 }];
        assert!(due.iter().all(SolveError::is_due_to_n));
        let others = [NoStart, Interrupted { n: 9 }, Energy { energy: f64::INFINITY }];
        assert!(!others.iter().any(SolveError::is_due_to_n));
    }
}
