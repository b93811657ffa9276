//! The round sphere in stereographic coordinates: `H(x) = 4 / (1 + |x|²)² I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::radial::squared_norm;
use crate::{
    Constants, KnownDistance, LocalError, LocallyBounded, Metric, locally_bounded::norms_within,
};

/// `H(x) = 4 / (1 + |x|²)² I`: the unit sphere `S^D` without one point.
///
/// The metric has no constant `c₁ > 0` on all of `R^D`, so none of the paper's theorems applies.
/// For `N ≥ 2` the infimum of the trapezoidal energy is `0` (a single jump far out and back), and
/// only minimisers among the sequences of a ball are meaningful (Proposition S.8).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sphere;

impl<const D: usize> Metric<D> for Sphere {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal_element((squared_norm(x) + 1.0).sqr().recip() * 4.0)
    }
}

impl<const D: usize> LocallyBounded<D> for Sphere {
    /// All constants are exact if `D ≥ 2`. With `s = |x|²`: `c₁ = 4/(1 + s)²` where the ball is
    /// farthest from the origin, and `c₂` where it is nearest; `L_H = 16 √s/(1 + s)³` at `s = 1/5`;
    /// `M_H` is the larger of `16/(1 + s)³` (across the ray, where the ball is nearest) and
    /// `16 (5s − 1)/(1 + s)⁴` (along the ray, at `s = 3/5`). If the ball contains no point with
    /// such an `s`, the nearest `s` in the ball replaces it.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        let [low, high] = norms_within(centre, radius)?.map(|r| r * r);
        let factor = |s: f64| 4.0 / (1.0 + s).powi(2);
        let [steep, bent] = [0.2_f64, 0.6].map(|s| s.max(low).min(high));
        let l_h = 16.0 * steep.sqrt() / (1.0 + steep).powi(3);
        let across = 16.0 / (1.0 + low).powi(3);
        let along = 16.0 * (5.0 * bent - 1.0) / (1.0 + bent).powi(4);
        let constants = Constants::new(factor(high), factor(low), l_h)?;
        Ok(constants.with_m_h(across.max(along))?.isotropic().on_a_region())
    }
}

impl<const D: usize> KnownDistance<D> for Sphere {
    /// Returns `2 arctan(|x − y| / √(1 + 2 x·y + |x|² |y|²))`, the angle between the points. In the
    /// plane the denominator is `|1 + x̄ y|`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (x2, y2, xy) = (x.norm_squared(), y.norm_squared(), x.dot(y));
        // We use (1 + x·y)² + |x|²|y|² − (x·y)², since the expanded sum cancels at antipodes.
        let denominator = ((1.0 + xy).powi(2) + (x2 * y2 - xy * xy).max(0.0)).sqrt();
        Some(2.0 * (x - y).norm().atan2(denominator))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::Sphere;
    use crate::KnownDistance;

    /// On a line through the origin `|x|²|y|² − (x·y)²` is zero, and its computed value may have
    /// either sign.
    #[test]
    fn antipodes_on_any_line_are_pi_apart() {
        for k in 1..2000 {
            let x = vector![f64::from(k).sin(), 2.0 * (0.7 * f64::from(k)).cos()];
            let y = -x / x.norm_squared();
            let d = Sphere.distance(&x, &y).expect("always known");
            // The denominator is the square root of a rounding error, about √(4 ε), and
            // |x − y| ≥ 2.
            assert!((d - std::f64::consts::PI).abs() <= 1e-7, "{x}: {d}");
        }
    }
}
