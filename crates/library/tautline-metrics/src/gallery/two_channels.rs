//! Two channels of equal cost, side by side: two Gaussian grooves in a plateau.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    clairaut::across_layers,
    error::{nonnegative, positive, squarable},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = n² I` in the plane, with the squared index
///
/// ```text
/// n² = 1 + a (1 − e^{−(x₂ − b)²/2s²}) (1 − e^{−(x₂ + b)²/2s²})
/// ```
///
/// which is 1 at the bottoms `x₂ = ±b` of the channels and `1 + a` far from them.
///
/// The reflection `x₂ ↦ −x₂` is an isometry. Between two points on the axis `x₂ = 0` minimal
/// geodesics therefore come in pairs, one through each channel, unless the ridge itself is
/// shortest. This makes the metric a test for multi-start solvers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoChannels {
    height: f64,
    offset: f64,
    width: f64,
    constants: Constants,
}

impl TwoChannels {
    /// Returns the plateau of height `a ≥ 0` in `m²/ℓ²` with two channels of width `s > 0`, at the
    /// distance `b > 0` on either side of the axis, both in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(height: f64, offset: f64, width: f64) -> Result<Self, GalleryError> {
        let a = nonnegative("height", height)?;
        let (b, s) = (positive("offset", offset)?, squarable("width", width)?);
        let constants = Constants::new(1.0, 1.0 + a, a / s * steepest(2.0 * b / s))?
            .with_m_h(a / s / s * 8.0 / 7.0)?
            .isotropic();
        Ok(Self { height, offset, width, constants })
    }
}

// With s = 1, let u = x₂ − b and v = x₂ + b, and let U, V be the Gaussians e^{−u²/2} and e^{−v²/2}.
// Then ψ = (1 − U)(1 − V) has the derivatives
//
//     ψ′ = uU (1 − V) + vV (1 − U),
//     ψ″ = (1 − u²) U (1 − V) + (1 − v²) V (1 − U) + 2uvUV.
//
// We show |ψ″| ≤ 8/7. From below: (1 − u²) U ≥ −m with m = 2e^{−3/2}, and 2uvUV ≥ −u²U² − v²V², so
// −ψ″ is at most the sum of m (1 − V) + v²V² and the same expression in u. Since −ln
// V ≤ ½/V − 1 + ln 2, and v² is −2 ln V, the expression is at most m + (1 − m) V − 2 (1 − ln 2) V²,
// hence at most m + (1 − m)²/(8 (1 − ln 2)) = 0.57117 < 4/7. From above: 2uvUV ≤ u²U² + v²V² leaves
//
//     U + V − 2UV + (u²U + v²V)(U + V − 1).
//
// This is at most 1 if t = U + V ≤ 1. Otherwise u²U = −2U ln U ≤ 2 (1 − U) and UV ≥ t − 1 show that
// it is at most 2 − t + 2 (t − 1)(2 − t) = (2 − t)(2t − 1) ≤ 9/8.

/// Returns a bound on `|ψ′|` over `x₂`, for `s = 1` and channels `gap = 2b` apart.
fn steepest(gap: f64) -> f64 {
    // |uU| ≤ e^{−1/2}, attained at |u| = 1. Between the channels the terms of ψ′ have opposite
    // signs, and each is at most e^{−1/2}. Beyond them (say u ≥ 0) v = u + gap, so the second term
    // is at most the value of vV at v = max(gap, 1). But |ψ′| ≤ 2/3 in any case: for all u, v ≥ 0
    // this is proved by bisection in interval arithmetic, in the test `two_channels_l_h_is_proven`.
    let v = gap.max(1.0);
    ((-0.5_f64).exp() + v * (-0.5 * v * v).exp()).min(2.0 / 3.0)
}

impl Metric<2> for TwoChannels {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let wall = |offset: f64| {
            let rho = (x[1] - offset) * (1.0 / self.width);
            -(rho.sqr() * -0.5).exp() + 1.0
        };
        let product = wall(self.offset) * wall(-self.offset);
        SMatrix::from_diagonal_element(product * self.height + 1.0)
    }
}

impl Bounded<2> for TwoChannels {
    /// `c₁ = 1` is attained at the bottoms; `c₂ = 1 + a` holds in the limit. With
    /// `v = max(2b/s, 1)`, `L_H = (a/s) min(⅔, e^{−1/2} + v e^{−v²/2})` and `M_H = (8/7) a/s²` are
    /// upper bounds, at most 1.1 and 1.4 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for TwoChannels {
    /// Returns `|x − y|` for two points on one bottom. Otherwise the distance follows from
    /// Clairaut's relation, as for [`Valleys`](super::Valleys), if the minimal geodesic does not
    /// turn back in `x₂`. It does not turn back if `x₁ = y₁`, or if the points are on different
    /// sides of a bottom, unless they are so far apart in `x₁` that the geodesic enters the bottom
    /// at an angle below some `10⁻⁶`. Returns `None` for other pairs.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        let (low, high) = (x[1].min(y[1]), x[1].max(y[1]));
        let across = (x[0] - y[0]).abs();
        if low == high && (across == 0.0 || low.abs() == self.offset) {
            return Some(across);
        }
        // Beyond 12 widths from the bottoms n² = 1 + a in f64. With these knots a quadrature cannot
        // miss a channel.
        let reach = 12.0 * self.width;
        let mut knots = vec![low, high];
        for bottom in [-self.offset, self.offset] {
            knots.extend([bottom - reach, bottom, bottom + reach]);
        }
        knots.retain(|&knot| low <= knot && knot <= high);
        knots.sort_by(f64::total_cmp);
        let wall = |offset: f64| -(-0.5 * (offset / self.width).powi(2)).exp_m1();
        let excess = |x2: f64| self.height * wall(x2 - self.offset) * wall(x2 + self.offset);
        across_layers(excess, &knots, across)
    }
}
