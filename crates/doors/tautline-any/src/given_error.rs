//! `GivenError`: why a problem that was given as values has no curve.

use tautline::{ANY, BlackBox, NotPeriodic, RequestError, SetError, TextError};

use crate::{ConstantsError, LARGEST_DIMENSION};

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
        "a metric that is no formula has at most {} dimensions without its derivatives along a vector, not \
         {dimension}",
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
    /// The metric does not have a period.
    #[error(transparent)]
    NotPeriodic(#[from] NotPeriodic),
    /// No constants were sought.
    #[error(transparent)]
    Constants(#[from] ConstantsError),
    /// The request has no curve.
    #[error(transparent)]
    Request(#[from] RequestError),
}
