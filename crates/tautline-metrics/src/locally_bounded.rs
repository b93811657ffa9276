//! `LocallyBounded`: a metric with constants on balls, and perhaps not on all of `R^D`.

use nalgebra::SVector;

use crate::{Bounded, Constants, HypothesisError, Metric};

/// A metric which knows constants on every ball where it has some.
///
/// Every [`Bounded`] metric is one: its constants hold on all balls. Others, as `4 / (1 + r²)² I`,
/// have no constant `c₁ > 0` on all of `R^D`, and none of the paper's theorems applies to them; but
/// shortest curves and discrete minimisers stay near their ends, where the constants of a ball do
/// (Proposition S.8).
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` knows no constants",
    note = "implement `Bounded<{D}>` if they hold on all of R^D, else `LocallyBounded<{D}>`",
    note = "a reference to a metric that is only locally bounded is none itself: pass a value"
)]
pub trait LocallyBounded<const D: usize>: Metric<D> {
    /// Returns constants that hold on the ball `|x − centre| ≤ radius`, both in `ℓ`; on all of `R^D`
    /// for `radius = ∞`.
    ///
    /// # Laws
    ///
    /// Those of [`Constants`], for all `x` and `y` of the ball; the flag
    /// [`is_local`](Constants::is_local) is set unless they hold on all of `R^D`.
    ///
    /// # Errors
    ///
    /// [`LocalError`] if the metric has none there.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError>;
}

impl<M: Bounded<D>, const D: usize> LocallyBounded<D> for M {
    /// Those of all of `R^D`.
    fn constants_within(&self, _: &SVector<f64, D>, _: f64) -> Result<Constants, LocalError> {
        Ok(self.constants())
    }
}

/// Why a metric has no constants on a ball.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalError {
    /// The metric is not defined on all of the ball.
    #[error("a ball of radius {radius} reaches to {reach}, but the metric ends at {limit}")]
    LeavesTheDomain {
        /// The radius of the ball, in `ℓ`.
        radius: f64,
        /// How far the ball reaches, in the coordinate or the norm that is limited.
        reach: f64,
        /// Where the metric ends.
        limit: f64,
    },
    /// No ball has such a radius.
    #[error("a radius of {radius} is negative or no number")]
    NotARadius {
        /// The radius that was given, in `ℓ`.
        radius: f64,
    },
    /// A constant is 0, infinite or NaN on the ball.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}

impl LocalError {
    /// Refuses a radius that is negative or NaN.
    ///
    /// # Errors
    ///
    /// [`LocalError::NotARadius`].
    pub fn check_radius(radius: f64) -> Result<(), LocalError> {
        if radius >= 0.0 { Ok(()) } else { Err(LocalError::NotARadius { radius }) }
    }
}

/// Returns `min |x|` and `max |x|` over a ball, in `ℓ`.
pub(crate) fn norms_within<const D: usize>(
    centre: &SVector<f64, D>,
    radius: f64,
) -> Result<[f64; 2], LocalError> {
    LocalError::check_radius(radius)?;
    let away = centre.norm();
    Ok([(away - radius).max(0.0), away + radius])
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::{LocalError, norms_within};
    use crate::{Bounded, LocallyBounded, gallery::Valleys};

    #[test]
    fn a_bounded_metric_has_its_constants_everywhere() {
        let all: crate::Constants = Bounded::<2>::constants(&Valleys);
        for radius in [0.0, 1.0, f64::INFINITY] {
            assert_eq!(Valleys.constants_within(&vector![1.0, 2.0], radius), Ok(all));
        }
    }

    #[test]
    fn a_ball_reaches_from_the_nearest_to_the_farthest_norm() {
        assert_eq!(norms_within(&vector![3.0, 4.0], 2.0), Ok([3.0, 7.0]));
        assert_eq!(norms_within(&vector![3.0, 4.0], 6.0), Ok([0.0, 11.0]));
        for radius in [-1.0, f64::NAN] {
            let error = norms_within(&vector![0.0], radius).expect_err("no radius");
            assert!(matches!(error, LocalError::NotARadius { .. }), "{error}");
        }
    }
}
