//! `GivenError`: why a problem that was given as values has no curve.

use tautline::{
    ANY, BlackBox, GraphPathError, LatticeSearchError, SequenceError, SetError, SolveError,
    TextError,
};

use crate::{ConstantsError, LARGEST_DIMENSION, LEAST_TOLERANCE};

/// Why a problem has no curve.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GivenError {
    /// The dimension is 0 or too large.
    #[error("{dimension} dimensions: only 1 to {LARGEST_DIMENSION} are possible")]
    Dimension {
        /// The dimension.
        dimension: usize,
    },
    /// A black box has too many dimensions.
    #[error(
        "a metric that is no formula has at most {} dimensions, not {dimension}",
        BlackBox::<ANY>::LARGEST_DIMENSION
    )]
    BlackBoxDimension {
        /// The dimension.
        dimension: usize,
    },
    /// The formula is wrong.
    #[error(transparent)]
    Text(#[from] TextError),
    /// A vector does not have one coordinate for each dimension.
    #[error("{what} has {found} coordinates in {dimension} dimensions")]
    Coordinates {
        /// What has them.
        what: &'static str,
        /// The number of coordinates.
        found: usize,
        /// The dimension.
        dimension: usize,
    },
    /// A set has no pieces.
    #[error("the {end} set has no pieces")]
    NoPieces {
        /// Which set: `first` or `second`.
        end: &'static str,
    },
    /// Both sets are unbounded, or members of a union differ in dimension.
    #[error(transparent)]
    Set(#[from] SetError),
    /// A start is no sequence of points.
    #[error("a start: {0}")]
    Start(#[from] SequenceError),
    /// The tolerance is less than [`LEAST_TOLERANCE`], or not less than 1.
    #[error(
        "the tolerance is {tolerance}; it must be at least {LEAST_TOLERANCE:e} and less than 1"
    )]
    Tolerance {
        /// The relative error of the length that was wanted.
        tolerance: f64,
    },
    /// A lattice was given besides a tolerance.
    #[error("a lattice besides a tolerance: a search along a lattice has a number of chords")]
    LatticeAndTolerance,
    /// The step of differences is not positive and finite.
    #[error("the step of differences is {step}; it must be positive and finite")]
    Step {
        /// The step, in `ℓ`.
        step: f64,
    },
    /// The margin of obstacles is not positive and finite.
    #[error("the margin of the obstacles is {margin}; it must be positive and finite")]
    Margin {
        /// The margin, in `ℓ`.
        margin: f64,
    },
    /// An obstacle has no inside.
    #[error("{set} is no obstacle: expected a ball of positive radius, or a half-space")]
    NoInside {
        /// What the set is.
        set: &'static str,
    },
    /// What needs a formula was asked of a black box.
    #[error("a metric that is no formula has no obstacles; let its function return NaN there")]
    NoFormula,
    /// No constants were sought.
    #[error(transparent)]
    Constants(#[from] ConstantsError),
    /// A lattice, or a path along it, is not there.
    #[error(transparent)]
    Lattice(#[from] GraphPathError),
    /// Nothing was found.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

impl From<LatticeSearchError> for GivenError {
    fn from(error: LatticeSearchError) -> Self {
        match error {
            LatticeSearchError::Path(error) => error.into(),
            LatticeSearchError::Solve(error) => error.into(),
        }
    }
}
