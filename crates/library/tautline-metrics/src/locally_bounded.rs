//! `LocallyBounded`: a metric with constants on balls, though perhaps not on all of `R^D`.

use nalgebra::SVector;
use tautline_scalar::Short;

use crate::{Constants, HypothesisError, Metric};

/// A metric that knows its constants on balls.
///
/// Some metrics, for example `4 / (1 + r²)² I`, have no constant `c₁ > 0` on all of `R^D`, and none
/// of the paper's theorems applies to them. But shortest curves and discrete minimisers stay near
/// their ends, where the constants of a ball suffice (Proposition S.8). A
/// [`Bounded`](crate::Bounded) metric, for example [`Constant`](crate::gallery::Constant), may be
/// locally bounded too, since the constants of a ball can be better.
///
/// ```
/// use tautline_metrics::{LocallyBounded, gallery::Sphere};
///
/// let ball = Sphere.constants_within(&[0.0, 0.0].into(), 1.0)?;
/// assert_eq!([ball.c1(), ball.c2()], [1.0, 4.0]);
/// assert!(ball.is_local());
/// assert!(Sphere.constants_within(&[0.0, 0.0].into(), f64::INFINITY).is_err());
/// # Ok::<(), tautline_metrics::LocalError>(())
/// ```
pub trait LocallyBounded<const D: usize>: Metric<D> {
    /// Returns constants that hold for all `x` and `y` in the ball `|x − centre| ≤ radius`, both in
    /// `ℓ`. They are marked as [local](Constants::is_local).
    ///
    /// # Errors
    ///
    /// [`LocalError`] if the metric has no constants there, or if [`LocalError::check_ball`]
    /// refuses the ball.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError>;
}

impl<M: LocallyBounded<D>, const D: usize> LocallyBounded<D> for &M {
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        (**self).constants_within(centre, radius)
    }
}

/// The reason why a metric has no constants on a ball.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalError {
    /// The metric is not defined on all of the ball.
    #[error(
        "a ball of radius {} reaches to {}, but the metric ends at {limit}",
        Short(*radius), Short(*reach)
    )]
    LeavesTheDomain {
        /// The radius of the ball, in `ℓ`.
        radius: f64,
        /// How far the ball reaches, measured in the coordinate or the norm that is limited.
        reach: f64,
        /// The value at which the domain of the metric ends.
        limit: f64,
    },
    /// The radius is negative or NaN.
    #[error("a radius of {radius} is negative or no number")]
    NotARadius {
        /// The radius that was given, in `ℓ`.
        radius: f64,
    },
    /// A coordinate of the centre is not finite.
    #[error("coordinate {index} of the centre is {value}")]
    NotACentre {
        /// The index of the coordinate, from 0.
        index: usize,
        /// The coordinate.
        value: f64,
    },
    /// No constants could be proved from the formula.
    #[error("no constants are proved on the ball of radius {}: {reason}", Short(*radius))]
    NotProved {
        /// The radius of the ball, in `ℓ`.
        radius: f64,
        /// The reason that the search reports.
        reason: String,
        /// Whether a larger budget may prove them.
        budget_spent: bool,
    },
    /// A constant is 0, infinite or NaN on the ball.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}

impl LocalError {
    /// Refuses a centre that is not finite, and a radius that is negative or NaN.
    ///
    /// # Errors
    ///
    /// [`LocalError::NotACentre`] if the centre is not finite; [`LocalError::NotARadius`] if the
    /// radius is negative or NaN.
    pub fn check_ball(centre: &[f64], radius: f64) -> Result<(), LocalError> {
        if let Some((index, &value)) = centre.iter().enumerate().find(|(_, x)| !x.is_finite()) {
            return Err(LocalError::NotACentre { index, value });
        }
        if radius >= 0.0 { Ok(()) } else { Err(LocalError::NotARadius { radius }) }
    }
}

/// Returns `min |x|` and `max |x|` over a ball, in `ℓ`.
pub(crate) fn norms_within<const D: usize>(
    centre: &SVector<f64, D>,
    radius: f64,
) -> Result<[f64; 2], LocalError> {
    LocalError::check_ball(centre.as_slice(), radius)?;
    let away = centre.norm();
    Ok([(away - radius).max(0.0), away + radius])
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::{LocalError, norms_within};

    #[test]
    fn norms_of_a_ball_and_the_balls_that_are_refused() {
        assert_eq!(norms_within(&vector![3.0, 4.0], 2.0), Ok([3.0, 7.0]));
        assert_eq!(norms_within(&vector![3.0, 4.0], 6.0), Ok([0.0, 11.0]));
        // The ball is a single point, then all of space.
        assert_eq!(norms_within(&vector![3.0, 4.0], 0.0), Ok([5.0, 5.0]));
        assert_eq!(norms_within(&vector![3.0, 4.0], 5.0), Ok([0.0, 10.0]));
        assert_eq!(norms_within(&vector![3.0, 4.0], f64::INFINITY), Ok([0.0, f64::INFINITY]));
        for radius in [-1.0, f64::NAN] {
            let error = norms_within(&vector![0.0], radius).expect_err("no radius");
            assert!(matches!(error, LocalError::NotARadius { .. }), "{error}");
        }
        let error = norms_within(&vector![0.0, f64::INFINITY], 1.0).expect_err("no centre");
        assert_eq!(error, LocalError::NotACentre { index: 1, value: f64::INFINITY });
        // The error names the first of two bad coordinates.
        let error = norms_within(&vector![f64::NEG_INFINITY, f64::NAN], 1.0).expect_err("none");
        assert_eq!(error, LocalError::NotACentre { index: 0, value: f64::NEG_INFINITY });
    }
}
