//! `MinimaError`: why there is no search.

use tautline::{GraphPathError, SolveError};

/// Why there is no search for minima.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MinimaError {
    /// A puncture, or the slack, is out of range.
    #[error(transparent)]
    Lattice(#[from] GraphPathError),
    /// No start led to a minimum. The error is that of the automatic search, if it failed.
    #[error("none of {starts} starts led to a minimum")]
    NoMinimum {
        /// The number of starts.
        starts: usize,
        /// Why the automatic search failed.
        source: Option<SolveError>,
    },
}
