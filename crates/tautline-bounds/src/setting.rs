//! `Setting`: all that Theorems 1.1 to 1.4 ask about a problem.

use tautline_metrics::Constants;

/// The setting of Theorem 1.1 in numbers: the constants of the metric, the distance
/// `d = d^g(X⁽⁰⁾, X⁽¹⁾)` of the ends, in `m`, and the dimension `D`.
///
/// Invariant: `0 ≤ d < ∞` and `D ≥ 1`, besides those of [`Constants`]. [`Setting::new`] is the
/// only way in, so a function which takes a `Setting` need not check again.
///
/// Every bound grows with `d`, `c₂` and `L_H` and falls with `c₁`: where only an upper bound of
/// the distance is known (the length of any admissible curve is one), it may stand for `d`, and
/// the results are still bounds.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    constants: Constants,
    distance: f64,
    dimension: usize,
}

impl Setting {
    /// Checks `distance`, in `m`, then `dimension`.
    ///
    /// `distance = 0` (ends that touch) is a setting: every bound is then 0.
    ///
    /// # Errors
    ///
    /// [`BoundError::NotADistance`] if `distance` is negative, infinite or NaN;
    /// [`BoundError::NoDimension`] if `dimension` is 0.
    pub fn new(
        constants: Constants,
        distance: f64,
        dimension: usize,
    ) -> Result<Setting, BoundError> {
        if !(distance >= 0.0 && distance.is_finite()) {
            return Err(BoundError::NotADistance { distance });
        }
        if dimension == 0 {
            return Err(BoundError::NoDimension);
        }
        // −0 is a distance too, but must not be printed as one.
        Ok(Setting { constants, distance: distance.abs(), dimension })
    }

    /// Returns the constants `c₁`, `c₂` and `L_H` of the metric.
    #[must_use]
    pub fn constants(&self) -> Constants {
        self.constants
    }

    /// Returns the distance `d` of the ends, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the dimension `D`.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }
}

/// A clause of the setting of Theorem 1.1 which the given numbers do not meet.
///
/// The clauses on `c₁`, `c₂` and `L_H` are those of
/// [`HypothesisError`](tautline_metrics::HypothesisError).
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BoundError {
    /// `d` is the distance of two nonempty sets.
    #[error("d = {distance} must be nonnegative and finite: it is a distance (Theorem 1.1)")]
    NotADistance {
        /// The number that was given.
        distance: f64,
    },
    /// The metric lives on `R^D` with `D ≥ 1`.
    #[error("D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)")]
    NoDimension,
}

#[cfg(test)]
mod tests {
    use super::{BoundError, Setting};
    use tautline_metrics::Constants;

    fn constants() -> Constants {
        Constants::new(1.0, 9.0, 5.0).expect("in order")
    }

    #[test]
    fn a_number_that_is_no_distance_is_refused() {
        for distance in [-1.0, -5e-324, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(
                Setting::new(constants(), distance, 2),
                Err(BoundError::NotADistance { distance })
            );
        }
        // NaN is not equal to itself, so the number is looked at by hand.
        let error = Setting::new(constants(), f64::NAN, 2).expect_err("NaN");
        assert!(matches!(error, BoundError::NotADistance { distance } if distance.is_nan()));
    }

    #[test]
    fn dimension_zero_is_refused() {
        assert_eq!(Setting::new(constants(), 1.0, 0), Err(BoundError::NoDimension));
        // Of two clauses that fail, the first is named.
        assert_eq!(
            Setting::new(constants(), -1.0, 0),
            Err(BoundError::NotADistance { distance: -1.0 })
        );
    }

    #[test]
    fn the_message_names_the_number_and_the_clause() {
        let error = Setting::new(constants(), -1.5, 2).expect_err("negative");
        assert_eq!(
            error.to_string(),
            "d = -1.5 must be nonnegative and finite: it is a distance (Theorem 1.1)"
        );
        assert_eq!(
            BoundError::NoDimension.to_string(),
            "D = 0 must be at least 1: it is the dimension of the space (Theorem 1.1)"
        );
    }

    #[test]
    fn what_was_put_in_comes_out() {
        let setting = Setting::new(constants(), 2.5, 3).expect("valid");
        assert_eq!(setting.constants(), constants());
        assert_eq!(setting.distance(), 2.5);
        assert_eq!(setting.dimension(), 3);
        let touching = Setting::new(constants(), -0.0, 1).expect("zero is a distance");
        assert!(touching.distance().is_sign_positive());
    }
}
