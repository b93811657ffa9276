//! Why nothing could be proved.

use tautline_formula::RecordError;
use tautline_metrics::HypothesisError;
use tautline_scalar::IntervalError;
use thiserror::Error;

use crate::Quantity;

/// Why a constant, or a box to look for it, is refused.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CertifyError {
    /// A side of a box is not an interval of finite numbers.
    #[error(
        "side {coordinate} of a box from {lo:?} to {hi:?}: the ends must be finite and in order"
    )]
    NotASide {
        /// The index of the side, from 0.
        coordinate: usize,
        /// The lower end, in `ℓ`.
        lo: f64,
        /// The upper end, in `ℓ`.
        hi: f64,
        /// What is wrong with the two ends; `None` if one is infinite.
        #[source]
        cause: Option<IntervalError>,
    },
    /// No ball has such a radius.
    #[error("a radius of {radius} is negative or not finite")]
    NotARadius {
        /// The radius that was given, in `ℓ`.
        radius: f64,
    },
    /// A metric that is declared to settle still changes at the reach of the domain.
    #[error(
        "along coordinate {coordinate} the metric still changes by up to {change} in proportion \
         when the distance is doubled"
    )]
    NotSettled {
        /// The index of the coordinate, from 0.
        coordinate: usize,
        /// A bound of the change, in proportion to the metric; NaN if there is none.
        change: f64,
    },
    /// Constants on all of `R^D` are asked for, and the formula does not show that the metric is
    /// periodic or constant along each coordinate.
    #[error("the formula does not show that a bounded domain stands for all of space")]
    NotAllOfSpace,
    /// The requested relative tolerance is not between 0 and 1.
    #[error("a relative tolerance of {tolerance} is not between 0 and 1")]
    NotATolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The formula cannot be recorded: proofs read it from its record, since intervals would follow one
    /// branch of several.
    #[error("nothing is proved of a formula that cannot be recorded: {0}")]
    NotRecorded(#[source] RecordError),
    /// There is no dimension.
    #[error("D = 0: there is no dimension")]
    NoDimension,
    /// At a point of the domain the formula, evaluated with bounds, is not shown to be defined: a
    /// root of something that may be negative, say, or the tangent of a number beyond `2²⁰`.
    #[error("the metric is not shown to be defined at {point:?}")]
    Undefined {
        /// Where it was evaluated, in `ℓ`.
        point: Vec<f64>,
    },
    /// The metric is not positive definite at a point of the domain: proved with outward rounding.
    #[error(
        "the metric is not positive definite at {point:?}: its least eigenvalue is {eigenvalue:?} \
         at most"
    )]
    NotPositiveDefinite {
        /// Where it was evaluated, in `ℓ`.
        point: Vec<f64>,
        /// A bound from above of the least eigenvalue there, in `m²/ℓ²`; not positive.
        eigenvalue: f64,
    },
    /// The budget of boxes was spent before the bounds were as close as asked for. What they had
    /// come to is right, only wider.
    #[error("after {boxes} boxes, {quantity} is only known to lie between {lower:?} and {upper:?}")]
    BudgetSpent {
        /// Which constant.
        quantity: Quantity,
        /// The bound from below, in the constant's unit.
        lower: f64,
        /// The bound from above, perhaps infinite.
        upper: f64,
        /// How many boxes were evaluated.
        boxes: usize,
    },
    /// The bounds are no constants of a metric: a bound of one overflows, say.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}
