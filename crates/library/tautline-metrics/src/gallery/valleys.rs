//! The valleys of Section 5: `H(x) = (2 − cos x₁)² I`.

use std::{
    f64::consts::{SQRT_2, TAU},
    iter::once,
};

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::clairaut::across_layers;
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = f² I` with `f = 2 − cos x₁`, which is cheap along `x₁ = 0, 2π, 4π` and three times as
/// expensive between these lines.
///
/// This is the counterexample of Section 5: the distance from `(0, 0)` to `(4π, 0)` is `8π`, but
/// the minimum of the discrete *lengths* is `4π` for every `N`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Valleys;

/// Returns an `F` with `F′ = f`.
fn primitive(x: f64) -> f64 {
    2.0 * x - x.sin()
}

impl<const D: usize> Metric<D> for Valleys {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal_element((2.0 - x[0].cos()).sqr())
    }
}

impl<const D: usize> Bounded<D> for Valleys {
    /// All constants are attained: `c₁ = 1`, `c₂ = 9`, `L_H = (3 + √3) 3^{1/4} / √2` where
    /// `cos x₁ = (1 − √3)/2`, and `M_H = 6` at `x₁ = π`.
    fn constants(&self) -> Constants {
        let root = 3_f64.sqrt();
        Constants::new(1.0, 9.0, (3.0 + root) * root.sqrt() / SQRT_2)
            .and_then(|constants| constants.isotropic().with_m_h(6.0))
            .expect("1 ≤ 9, and the others are positive")
    }
}

impl<const D: usize> KnownDistance<D> for Valleys {
    /// Along `x₁` the distance is `F(b) − F(a)` with `F = 2x₁ − sin x₁`; otherwise it follows from
    /// Clairaut's relation. Returns `None` if the minimal geodesic turns back in `x₁` or crosses
    /// more than ten thousand valleys.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (a, b) = (x[0].min(y[0]), x[0].max(y[0]));
        let across = (1..D).map(|i| (x[i] - y[i]).powi(2)).sum::<f64>().sqrt();
        if across == 0.0 {
            return Some(primitive(b) - primitive(a));
        }
        // There is one quadrature per valley.
        let (first, last) = ((a / TAU).floor() + 1.0, (b / TAU).ceil() - 1.0);
        if !(last - first <= 1e4) {
            return None;
        }
        let inside = (0..).map(|k| first + f64::from(k)).take_while(|&k| k <= last);
        let knots: Vec<f64> = once(a).chain(inside.map(|k| k * TAU)).chain([b]).collect();
        // f² − 1 = (1 − cos x₁)(3 − cos x₁).
        across_layers(|x1| 2.0 * (0.5 * x1).sin().powi(2) * (3.0 - x1.cos()), &knots, across)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::vector;

    use std::f64::consts::{PI, SQRT_2, TAU};

    use super::Valleys;
    use crate::{Bounded, KnownDistance};

    /// A geodesic over `m` valleys is periodic and `m` times as long as a geodesic over one. A
    /// single quadrature over all of them would not converge.
    #[test]
    fn the_distance_over_many_valleys_is_a_multiple_of_the_distance_over_one() {
        let over = |valleys: f64, across: f64| {
            let (x, y) = (vector![0.3, 0.0], vector![0.3 + valleys * TAU, valleys * across]);
            Valleys.distance(&x, &y).expect("it does not turn back")
        };
        for across in [0.5, 3.0] {
            let one = over(1.0, across);
            assert!(one < TAU.hypot(across) * 3.0);
            for valleys in [2.0, 25.0, 100.0] {
                assert_relative_eq!(over(valleys, across), valleys * one, max_relative = 1e-12);
            }
        }
        let far = Valleys.distance(&vector![0.0, 0.0], &vector![1e6, 1.0]);
        assert_eq!(far, None);
    }

    /// As `p → 1` the distance tends to `20 + ∫ √(f² − 1) dx₁`, up to a multiple of `e^{−20}`. The
    /// integral is elementary in `u = cos x₁/2`.
    #[test]
    fn a_long_way_along_a_valley_keeps_its_digits() {
        let d =
            |x: f64, y: f64| Valleys.distance(&vector![x, 0.0], &vector![y, 20.0]).expect("p < 1");
        let climb = |x: f64| {
            let u = (0.5 * x).cos();
            2.0 - 2.0 * u * (2.0 - u * u).sqrt() + PI - 4.0 * (u / SQRT_2).asin()
        };
        let limit = 20.0 + climb(1.0) + climb(1.5);
        assert_relative_eq!(d(-1.0, 1.5), limit, max_relative = 1e-8);
        assert!(d(-1.0, 1.5) > limit);
        // This is the mirror image.
        assert_relative_eq!(d(-1.0, 1.5), d(1.0, -1.5), max_relative = 1e-15);
    }

    #[test]
    fn a_pair_on_a_ridge_is_not_known() {
        assert_eq!(Valleys.distance(&vector![3.0, 0.0], &vector![3.0, 5.0]), None);
    }

    #[test]
    fn the_lipschitz_constant_is_the_golden_one() {
        let constants = Bounded::<2>::constants(&Valleys);
        assert_relative_eq!(constants.l_h(), 4.403_669_475_041_611_7, max_relative = 1e-15);
    }
}
