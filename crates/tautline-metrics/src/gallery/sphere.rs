//! The round sphere in stereographic coordinates: `H(x) = 4 / (1 + |x|²)² I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::{KnownDistance, Metric};

/// `H(x) = 4 / (1 + |x|²)² I`: the unit sphere `S^D` without a point.
///
/// It has no constant `c₁ > 0`, so none of the theorems applies: the discrete energies have
/// the infimum `0` for `N ≥ 2` (one jump far out and back), and only local minimisers mean
/// anything.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sphere;

impl<const D: usize> Metric<D> for Sphere {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let r2 = x.iter().fold(S::zero(), |sum, xi| sum + xi.sqr());
        SMatrix::from_diagonal_element((r2 + 1.0).sqr().recip() * 4.0)
    }
}

impl<const D: usize> KnownDistance<D> for Sphere {
    /// `2 arctan(|x − y| / √(1 + 2 x·y + |x|² |y|²))`, the angle between the points: in the
    /// plane the denominator is `|1 + x̄ y|`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (x2, y2, xy) = (x.norm_squared(), y.norm_squared(), x.dot(y));
        // (1 + x·y)² + |x|²|y|² − (x·y)² rather than a sum that cancels at antipodes.
        let denominator = ((1.0 + xy).powi(2) + (x2 * y2 - xy * xy).max(0.0)).sqrt();
        Some(2.0 * (x - y).norm().atan2(denominator))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::vector;

    use super::Sphere;
    use crate::KnownDistance;

    /// `2 · (½ 0.8853…)`, and antipodes at `π`.
    #[test]
    fn distances_are_angles() {
        let d = Sphere.distance(&vector![-0.8, 0.3], &vector![1.1, 0.6]).expect("always known");
        assert_relative_eq!(d * d, 5.278_323_900_279_761, max_relative = 1e-14);
        let d = Sphere.distance(&vector![0.5, 0.0], &vector![-2.0, 0.0]).expect("always known");
        assert_relative_eq!(d, std::f64::consts::PI, max_relative = 1e-15);
    }
}
