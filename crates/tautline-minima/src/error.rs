//! `MinimaError`: why there is no search.

use tautline::SolveError;

/// Why there is no search for minima.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MinimaError {
    /// A puncture is not finite, or stands twice.
    #[error("puncture {number} at {point:?} is not finite, or stands twice")]
    Puncture {
        /// The number of the puncture, from 1.
        number: usize,
        /// The point, in `ℓ`.
        point: [f64; 2],
    },
    /// A peak is at least as high as its pass.
    #[error("a prominence of {prominence}; expected a number from 1 on")]
    Prominence {
        /// The quotient of the heights.
        prominence: f64,
    },
    /// Paths are at least as long as the shortest.
    #[error("paths of up to {slack} times the shortest; expected a number from 1 on")]
    Slack {
        /// The quotient of the lengths.
        slack: f64,
    },
    /// No start led to a minimum. The error is that of the automatic search, if it failed.
    #[error("none of {starts} starts led to a minimum")]
    NoMinimum {
        /// The number of starts.
        starts: usize,
        /// Why the automatic search failed.
        source: Option<SolveError>,
    },
}
