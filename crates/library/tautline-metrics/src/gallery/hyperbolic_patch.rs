//! A ball of hyperbolic space: `H(x) = 4 / (1 − S(|x|²))² I` with a saturated `S`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError, Hyperbolic,
    error::between,
    radial::squared_norm,
    saturation::{INVERSE, P, PLATEAU, greatest, rest, saturate_at},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = 4 / (1 − S(|x|²))² I`, in any dimension, with
///
/// ```text
/// S(q) = q / (1 + (q/Q)^p)^{1/p},    p = 128,    Q = 4R²/3 < 1
/// ```
///
/// In the ball `|x| ≤ R` it agrees with [`Hyperbolic`] to within a few ulps in the value and the
/// first derivatives, and to within `10⁻¹²` in the second derivatives. Far outside it is the
/// constant `4 / (1 − Q)²`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HyperbolicPatch {
    radius: f64,
    limit: f64,
    constants: Constants,
}

impl HyperbolicPatch {
    /// Returns the patch of coordinate radius `R` (a pure number), which is the ball of radius
    /// `2 artanh R` in hyperbolic space.
    ///
    /// # Errors
    ///
    /// [`GalleryError::OutOfRange`] unless `10⁻⁵⁰ < R < 0.86`; at `√3/2` the limit `Q` would be 1.
    pub fn new(radius: f64) -> Result<Self, GalleryError> {
        between("radius", radius, 1e-50, 0.86)?;
        let limit = radius * radius / PLATEAU;
        // H = φ(q) I with q = |x|² and φ = 4 (1 − S)^{−2}. Put z = S/Q and b = 1 − z^p. Then
        // S′ = b^{1+1/p}, S″ = −((p + 1)/Q) z^{p−1} b^{1+2/p} and q = S b^{−1/p}.
        //
        // |∇φ| = 2 √q φ′ = 16 √q S′ (1 − S)^{−3} = 16 √S b^{1+1/2p} (1 − S)^{−3}.
        let s = |z: f64| limit * z;
        let slope = |a, b| s(b).sqrt() * rest(a, 1.0 + 0.5 * INVERSE) / (1.0 - s(b)).powi(3);
        let l_h = 16.0 * greatest(slope);
        // For the radial part c of a unit vector w, D²φ[w, w] = 2φ′ + 4c² q φ″ lies between
        //     2φ′         = 16 b^{1+1/p} (1 − S)^{−3} ≥ 0  and
        //     2φ′ + 4qφ″  = 2φ′ + 96 S b^{2+1/p} (1 − S)^{−4}
        //                       − 32 (p + 1) z^p b^{1+1/p} (1 − S)^{−3}.
        let grows = |a: f64, b: f64| {
            16.0 * rest(a, 1.0 + INVERSE) / (1.0 - s(b)).powi(3)
                + 96.0 * s(b) * rest(a, 2.0 + INVERSE) / (1.0 - s(b)).powi(4)
        };
        let bends = |a: f64, b: f64| {
            32.0 * f64::from(P + 1) * b.powi(P) * rest(a, 1.0 + INVERSE) / (1.0 - s(b)).powi(3)
        };
        let across = |a: f64, b: f64| 16.0 * rest(a, 1.0 + INVERSE) / (1.0 - s(b)).powi(3);
        // Exchanging the ends of a cell turns an upper bound on a term into a lower bound.
        let m_h = greatest(|a, b| grows(a, b) - bends(b, a))
            .max(greatest(|a, b| bends(a, b) - grows(b, a)))
            .max(greatest(across));
        let c2 = 4.0 / (1.0 - limit).powi(2);
        let constants = Constants::new(4.0, c2, l_h)?.with_m_h(m_h)?.isotropic();
        Ok(Self { radius, limit, constants })
    }
}

impl<const D: usize> Metric<D> for HyperbolicPatch {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let saturated = saturate_at(self.limit, squared_norm(x));
        SMatrix::from_diagonal_element((-saturated + 1.0).sqr().recip() * 4.0)
    }
}

impl<const D: usize> Bounded<D> for HyperbolicPatch {
    /// `c₁ = 4` at the centre; `c₂ = 4 / (1 − Q)²` holds in the limit. `L_H` and `M_H` are maxima
    /// of functions of `S` over the transition, computed by branch and bound; their relative error
    /// is at most `10⁻³`, upwards.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for HyperbolicPatch {
    /// Returns the distance in the metric [`Hyperbolic`] if both points lie in the patch, and
    /// `None` for other pairs.
    ///
    /// Outside the patch `φ` does not decrease along a ray, so projecting a curve to the rim along
    /// rays makes no piece longer. So no curve is shorter than the curves in the patch, which have
    /// their hyperbolic length. Balls are convex, so the geodesic stays in the patch.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let r2 = self.radius * self.radius;
        let inside = x.norm_squared() <= r2 && y.norm_squared() <= r2;
        if inside { Hyperbolic.distance(x, y) } else { None }
    }
}
