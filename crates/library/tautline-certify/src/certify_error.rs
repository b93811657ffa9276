//! `CertifyError`: why nothing could be proved.

use tautline_formula::RecordError;
use tautline_metrics::HypothesisError;
use tautline_scalar::{
    IntervalError,
    decimal::{shortly_down, shortly_up},
};
use thiserror::Error;

use crate::Quantity;

/// The significant digits of a bound in a message.
const DIGITS: usize = 4;

/// Why a constant or a domain was refused.
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
    /// A radius is negative or not finite.
    #[error("a radius of {radius} is negative or not finite")]
    NotARadius {
        /// The radius that was given, in `ℓ`.
        radius: f64,
    },
    /// A metric was declared to settle, but still changes at the reach of the domain.
    #[error("far out along x{} the metric is not proved to become constant{}", coordinate + 1, by(*change))]
    NotSettled {
        /// The index of the coordinate, from 0.
        coordinate: usize,
        /// A bound on the relative change; NaN if there is none.
        change: f64,
    },
    /// Constants on all of `R^D` need a formula that shows the metric to be periodic, to settle or to
    /// be constant along each coordinate.
    #[error("the formula does not show that a bounded domain represents all of space")]
    NotAllOfSpace,
    /// The requested relative tolerance is not between 0 and 1.
    #[error("a relative tolerance of {tolerance} is not between 0 and 1")]
    NotATolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The formula cannot be recorded, or the halves of its matrix are not known to be equal. Proofs
    /// need the record, because intervals would follow only one branch, and they read one half.
    #[error("nothing is proved of this formula: {0}")]
    NotRecorded(#[source] RecordError),
    /// The formula reads a second derivative of a table, whose own derivative jumps. So does that of `H`,
    /// and there is no `M_H`, though second derivatives may be bounded between the jumps. (A third
    /// derivative, which no text calls, jumps itself, and there is no constant.)
    #[error("there is no such constant: derivatives of the metric jump with those of a table")]
    Jumps,
    /// The dimension is 0.
    #[error("D = 0: there is no dimension")]
    NoDimension,
    /// A point or a domain lies in another space.
    #[error("{what} with {found} coordinates in {dimension} dimensions")]
    Coordinates {
        /// What it is.
        what: &'static str,
        /// The number of its coordinates.
        found: usize,
        /// The dimension.
        dimension: usize,
    },
    /// At a point of the domain the formula, evaluated in intervals, may be undefined: a root of a
    /// number that may be negative, for example, or the tangent of a number beyond `2³⁸`.
    #[error("the metric may be undefined at {point:?}")]
    Undefined {
        /// The point at which it was evaluated, in `ℓ`.
        point: Vec<f64>,
    },
    /// The metric is not positive definite at a point of the domain. This is proved with outward
    /// rounding.
    #[error(
        "the metric is not positive definite at {point:?}: its least eigenvalue is at most {}",
        shortly_up(*eigenvalue, DIGITS)
    )]
    NotPositiveDefinite {
        /// The point at which it was evaluated, in `ℓ`.
        point: Vec<f64>,
        /// An upper bound on the least eigenvalue there, in `m²/ℓ²`; it is not positive.
        eigenvalue: f64,
    },
    /// The budget of boxes was spent before the bounds were close enough. The bounds are still
    /// valid.
    #[error("after {boxes} boxes, {}", known(*quantity, *lower, *upper))]
    BudgetSpent {
        /// The constant in question.
        quantity: Quantity,
        /// The lower bound, in the constant's unit.
        lower: f64,
        /// The upper bound, in the same unit; possibly infinite.
        upper: f64,
        /// How many boxes were evaluated.
        boxes: usize,
    },
    /// The bounds do not form the constants of a metric; for example, one of them overflows.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}

impl CertifyError {
    /// Refuses a number of coordinates that is not the dimension.
    pub(crate) fn check_coordinates(
        what: &'static str,
        found: usize,
        dimension: usize,
    ) -> Result<(), Self> {
        let other = Self::Coordinates { what, found, dimension };
        if found == dimension { Ok(()) } else { Err(other) }
    }
}

/// Says what is known of a constant.
fn known(quantity: Quantity, lower: f64, upper: f64) -> String {
    let side = match (lower.is_finite(), upper.is_finite()) {
        (true, true) => {
            let (lower, upper) = (shortly_down(lower, DIGITS), shortly_up(upper, DIGITS));
            return format!("{quantity} is known only to lie between {lower} and {upper}");
        }
        (true, false) => "upper bound",
        (false, true) => "lower bound",
        (false, false) => "bound",
    };
    format!("{quantity} has no {side}: the formula may be undefined or infinite somewhere")
}

/// Says how much a metric still changes, if that is known.
fn by(change: f64) -> String {
    if change.is_nan() {
        return String::new();
    }
    format!(
        ": it changes by up to {} of itself when the distance is doubled",
        shortly_up(change, DIGITS)
    )
}

#[cfg(test)]
mod tests {
    use super::CertifyError;
    use crate::Quantity;

    /// The double 0.1 is a little above 0.1, and -0.1 below: a decimal to nearest would not bound them.
    #[test]
    fn bounds_in_messages_are_rounded_outward() {
        let (quantity, boxes) = (Quantity::C1, 7);
        let spent = CertifyError::BudgetSpent { quantity, lower: -0.1, upper: 0.1, boxes };
        let text = spent.to_string();
        assert!(text.ends_with("between -0.1001 and 0.1001"), "{text}");
        let indefinite = CertifyError::NotPositiveDefinite { point: vec![0.0], eigenvalue: -0.3 };
        // The double 0.3 is below 0.3, so that -0.3 is not below the double.
        assert!(indefinite.to_string().ends_with("at most -0.2999"), "{indefinite}");
    }

    #[test]
    fn a_change_in_a_message_is_rounded_up() {
        let settles = |change: f64| CertifyError::NotSettled { coordinate: 2, change }.to_string();
        let text = settles(0.1);
        assert!(text.contains("along x3") && text.contains(" up to 0.1001 of itself"), "{text}");
        let unknown = settles(f64::NAN);
        assert!(unknown.ends_with("become constant"), "{unknown}");
    }

    #[test]
    fn a_message_names_the_bound_that_is_missing() {
        let says = |lower: f64, upper: f64| {
            let spent =
                CertifyError::BudgetSpent { quantity: Quantity::LH, lower, upper, boxes: 9 };
            spent.to_string()
        };
        let (all, none) = (f64::INFINITY, f64::NEG_INFINITY);
        for (text, expected) in [
            (says(1.0, all), "L_H has no upper bound"),
            (says(none, 1.0), "L_H has no lower bound"),
            (says(none, all), "L_H has no bound"),
        ] {
            assert!(text.starts_with(&format!("after 9 boxes, {expected}:")), "{text}");
        }
    }
}
