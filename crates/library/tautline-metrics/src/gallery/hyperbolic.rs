//! Hyperbolic space in Poincaré's ball model: `H(x) = 4 / (1 − |x|²)² I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::radial::squared_norm;
use crate::{
    Constants, KnownDistance, LocalError, LocallyBounded, Metric, locally_bounded::norms_within,
};

/// `H(x) = 4 / (1 − |x|²)² I` in the open unit ball. It is NaN outside and infinite on the
/// boundary.
///
/// The metric is not defined on all of `R^D` and has no constant `c₂`, so none of the paper's
/// theorems applies. It does have all constants on every ball inside the unit ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hyperbolic;

impl<const D: usize> Metric<D> for Hyperbolic {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        // The square root makes the result NaN outside the ball. There (1 − |x|²)² is positive
        // again and would pass for a metric.
        let root = (-squared_norm(x) + 1.0).sqrt();
        SMatrix::from_diagonal_element((root.sqr().recip() * 2.0).sqr())
    }
}

impl<const D: usize> LocallyBounded<D> for Hyperbolic {
    /// All constants are exact. With `s = |x|²`: `c₁ = 4/(1 − s)²` where the ball is nearest to the
    /// origin; `c₂`, and along the ray `L_H = 16 √s/(1 − s)³` and `M_H = 16 (1 + 5s)/(1 − s)⁴`,
    /// where the ball is farthest from the origin.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        let [near, far] = norms_within(centre, radius)?;
        if !(far < 1.0) {
            return Err(LocalError::LeavesTheDomain { radius, reach: far, limit: 1.0 });
        }
        // 1 − s, computed without cancellation.
        let inner = |r: f64| (1.0 - r) * (1.0 + r);
        let l_h = 16.0 * far / inner(far).powi(3);
        let m_h = 16.0 * (1.0 + 5.0 * far * far) / inner(far).powi(4);
        let constants = Constants::new(4.0 / inner(near).powi(2), 4.0 / inner(far).powi(2), l_h)?;
        Ok(constants.with_m_h(m_h)?.isotropic().on_a_region())
    }
}

impl<const D: usize> KnownDistance<D> for Hyperbolic {
    /// Returns `arcosh(1 + 2δ) = 2 arsinh √δ` with `δ = |x − y|² / ((1 − |x|²)(1 − |y|²))`, by the
    /// second form, which does not cancel for near points. Returns `None` if a point is not in the
    /// open ball.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (inner_x, inner_y) = (1.0 - x.norm_squared(), 1.0 - y.norm_squared());
        let inside = inner_x > 0.0 && inner_y > 0.0;
        inside.then(|| 2.0 * ((x - y).norm() / (inner_x * inner_y).sqrt()).asinh())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::Hyperbolic;
    use crate::{KnownDistance, LocalError, LocallyBounded};

    /// One or both of the points lie on the rim or beyond.
    #[test]
    fn there_is_no_distance_to_the_rim_or_beyond() {
        let inside = vector![0.3, 0.4];
        let outside = [vector![1.0, 0.0], vector![0.6, 0.9], vector![-2.0, 0.0], vector![0.0, 1e9]];
        assert!(Hyperbolic.distance(&inside, &-inside).is_some());
        for x in outside {
            assert_eq!(Hyperbolic.distance(&x, &inside), None);
            assert_eq!(Hyperbolic.distance(&inside, &x), None);
            for y in outside {
                assert_eq!(Hyperbolic.distance(&x, &y), None, "{x} {y}");
            }
        }
    }

    #[test]
    fn a_ball_up_to_the_rim_has_no_constants() {
        for (centre, radius) in [(vector![0.0, 0.0], 1.0), (vector![0.5, 0.0], 0.5)] {
            let error = Hyperbolic.constants_within(&centre, radius).expect_err("the rim");
            let expected = LocalError::LeavesTheDomain { radius, reach: 1.0, limit: 1.0 };
            assert_eq!(error, expected);
            assert!(Hyperbolic.constants_within(&centre, radius * 0.999).is_ok());
        }
    }
}
