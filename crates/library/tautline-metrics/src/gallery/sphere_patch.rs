//! A patch of the round sphere: `H(x) = 4 / (1 + S(|x|²))² I` with a saturated `S`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError, Sphere,
    error::between,
    radial::squared_norm,
    saturation::{INVERSE, P, PLATEAU, greatest, rest, saturate_at},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = 4 / (1 + S(|x|²))² I`, in any dimension, with
///
/// ```text
/// S(q) = q / (1 + (q/Q)^p)^{1/p},    p = 128,    Q = 4R²/3
/// ```
///
/// In the patch `|x| ≤ R` it agrees with [`Sphere`] to within a few ulps in the value and the first
/// derivatives, and to within `10⁻¹²` in the second derivatives. Far outside it is the constant
/// `4 / (1 + Q)²`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpherePatch {
    radius: f64,
    limit: f64,
    constants: Constants,
}

impl SpherePatch {
    /// Returns the patch of coordinate radius `R` (a pure number), which is the ball of radius
    /// `2 arctan R` on the sphere; for `R = 1` it is a hemisphere.
    ///
    /// # Errors
    ///
    /// [`GalleryError::OutOfRange`] unless `10⁻⁵⁰ < R < 10⁵⁰`.
    pub fn new(radius: f64) -> Result<Self, GalleryError> {
        between("radius", radius, 1e-50, 1e50)?;
        let limit = radius * radius / PLATEAU;
        // H = φ(q) I with q = |x|² and φ = 4 (1 + S)^{−2}. Put z = S/Q and b = 1 − z^p. Then
        // S′ = b^{1+1/p}, S″ = −((p + 1)/Q) z^{p−1} b^{1+2/p} and q = S b^{−1/p}.
        //
        // |∇φ| = 2 √q |φ′| = 16 √q S′ (1 + S)^{−3} = 16 √S b^{1+1/2p} (1 + S)^{−3}. Here b ≤ 1, and
        // √S (1 + S)^{−3} grows up to S = 1/5. Unless the patch is small, this point lies in it,
        // where b = 1.
        let s = |z: f64| limit * z;
        let l_h = if radius * radius >= 0.2 {
            16.0 * 0.2_f64.sqrt() / 1.2_f64.powi(3)
        } else {
            let cell = |a, b| s(b).sqrt() * rest(a, 1.0 + 0.5 * INVERSE) / (1.0 + s(a)).powi(3);
            16.0 * greatest(cell)
        };
        // For the radial part c of a unit vector w, D²φ[w, w] = 2φ′ + 4c² q φ″ lies between
        //     2φ′         = −16 b^{1+1/p} (1 + S)^{−3}, which is −16 at the centre and above it
        //                   elsewhere, and
        //     2φ′ + 4qφ″  = 2φ′ + 96 S b^{2+1/p} (1 + S)^{−4}
        //                       + 32 (p + 1) z^p b^{1+1/p} (1 + S)^{−3} ≥ −16.
        // For Q ≥ 4 it is below 16: the first two terms are at most
        // (80 S − 16) (1 + S)^{−4} ≤ 625/128 (at S = 3/5). Since 1 + Qz ≥ (1 + Q) z, the third term
        // is at most 32 · 129 z^{125} (1 − z^{128}) / 125, where z^{125} (1 − z^{128}) ≤ 0.2542 (at
        // z^{128} = 125/253).
        let m_h = if limit < 4.0 {
            let bend = 32.0 * f64::from(P + 1);
            let radial = |a: f64, b: f64| {
                let falls = 16.0 * rest(b, 1.0 + INVERSE) / (1.0 + s(b)).powi(3);
                let grows = 96.0 * s(b) * rest(a, 2.0 + INVERSE) / (1.0 + s(a)).powi(4);
                grows - falls + bend * b.powi(P) * rest(a, 1.0 + INVERSE) / (1.0 + s(a)).powi(3)
            };
            greatest(radial).max(16.0)
        } else {
            16.0
        };
        let c1 = 4.0 / (1.0 + limit).powi(2);
        let constants = Constants::new(c1, 4.0, l_h)?.with_m_h(m_h)?.isotropic();
        Ok(Self { radius, limit, constants })
    }
}

impl<const D: usize> Metric<D> for SpherePatch {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let saturated = saturate_at(self.limit, squared_norm(x));
        SMatrix::from_diagonal_element((saturated + 1.0).sqr().recip() * 4.0)
    }
}

impl<const D: usize> Bounded<D> for SpherePatch {
    /// `c₁ = 4 / (1 + Q)²` holds in the limit; `c₂ = 4` is attained at the centre.
    /// `L_H = (16/√5) (5/6)³` is attained if `R² ≥ 1/5`, and `M_H = 16`, at the centre, if
    /// `R ≥ 1.6`.
    ///
    /// Otherwise `L_H` and `M_H` are maxima of functions of `S` over the transition, computed by
    /// branch and bound; their relative error is at most `10⁻³`, upwards.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for SpherePatch {
    /// Returns the angle between the points ([`Sphere`]) if they and the shorter arc of their great
    /// circle lie in the patch, and `None` for other pairs. For `R ≤ 1` the arc always does.
    ///
    /// Since `S(q) ≤ q`, `H` is nowhere less than the metric of the sphere, and no curve is shorter
    /// than on the sphere. The arc has the same length in both metrics.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (x2, y2, r2) = (x.norm_squared(), y.norm_squared(), self.radius * self.radius);
        if !(x2 <= r2 && y2 <= r2) {
            return None;
        }
        let angle = Sphere.distance(x, y)?;
        // We compare heights above the equator; the rim is the lowest part of the patch. At
        // distance s from the middle of the arc the height is m cos s + t sin s,
        // −angle/2 ≤ s ≤ angle/2. The lowest point of the whole circle has the height −√(m² + t²).
        // If it is not on the arc, one of the ends is lowest. The same holds for equal points,
        // where t is NaN.
        let height = |r2: f64| (1.0 - r2) / (1.0 + r2);
        let (a, b) = (height(x2), height(y2));
        let (sin, cos) = (0.5 * angle).sin_cos();
        let (m, t) = (0.5 * (a + b) / cos, 0.5 * (b - a) / sin);
        let amplitude = m.hypot(t);
        let dips = -m > amplitude * cos;
        (!dips || -amplitude >= height(r2)).then_some(angle)
    }
}
