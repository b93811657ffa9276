//! A strip of the Fisher metric of normal distributions: `H = diag(e^{−2S(t)}, 2)`, with a saturated
//! `S`.

use std::f64::consts::FRAC_1_SQRT_2;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError, GaussianFisher,
    error::between,
    saturation::{INVERSE, P, PLATEAU, greatest, rest, saturate_at},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(μ, t) = diag(e^{−2S(t)}, 2)` with
///
/// ```text
/// S(t) = t / (1 + (t/Q)^p)^{1/p},    p = 128,    Q = 4T/3
/// ```
///
/// For `|t| ≤ T` it agrees with [`GaussianFisher`]: the first derivatives to within a few ulps of
/// `1 + T`, and the second derivative to within `10⁻¹² (1 + 1/T)`. All numbers are pure.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "information geometry")]
pub struct GaussianFisherPatch {
    rim: f64,
    limit: f64,
    constants: Constants,
}

impl GaussianFisherPatch {
    /// Returns the metric that agrees with the Fisher metric for `e^{−T} ≤ σ ≤ e^T`.
    ///
    /// # Errors
    ///
    /// [`GalleryError::OutOfRange`] unless `10⁻⁵⁰ < T < 260`; for larger `T`, `e^{8T/3}` overflows.
    pub fn new(rim: f64) -> Result<Self, GalleryError> {
        between("rim", rim, 1e-50, 260.0)?;
        let limit = rim / PLATEAU;
        let c2 = (2.0 * limit).exp();
        // With z = S/Q and b = 1 − z^p: S′ = b^{1+1/p} and S″ = −((p + 1)/Q) z^{p−1} b^{1+2/p}.
        //
        // |∂ₜ e^{−2S}| = 2 S′ e^{−2S} is largest for t < 0.
        let growth = |z: f64| (2.0 * limit * z).exp();
        let l_h = 2.0 * greatest(|a, b| growth(b) * rest(a, 1.0 + INVERSE));
        // ∂ₜ² e^{−2S} = (4S′² − 2S″) e^{−2S}; the terms have opposite signs for t < 0 and the same
        // sign for t > 0.
        let square = |a: f64| 4.0 * rest(a, 2.0 + 2.0 * INVERSE);
        let bend = 2.0 * f64::from(P + 1) / limit;
        let bends = |a: f64, b: f64| bend * b.powi(P - 1) * rest(a, 1.0 + 2.0 * INVERSE);
        let m_h = greatest(|a, b| growth(b) * square(a) - growth(a) * bends(b, a))
            .max(greatest(|a, b| growth(b) * bends(a, b) - growth(a) * square(b)))
            .max(greatest(|a, b| (square(a) + bends(a, b)) / growth(a)));
        let constants = Constants::new(1.0 / c2, c2.max(2.0), l_h)?.with_m_h(m_h)?;
        Ok(Self { rim, limit, constants })
    }
}

impl Metric<2> for GaussianFisherPatch {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let information = (saturate_at(self.limit, x[1]) * -2.0).exp();
        SMatrix::from_diagonal(&SVector::from([information, S::constant(2.0)]))
    }
}

impl Bounded<2> for GaussianFisherPatch {
    /// `c₁ = e^{−2Q}` holds in the limit; `c₂ = max(e^{2Q}, 2)` holds in the limit or everywhere.
    /// `L_H` and `M_H` are maxima of functions of `S` over the transition, computed by branch and
    /// bound; their relative error is at most `2 · 10⁻³`, upwards.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for GaussianFisherPatch {
    /// Returns the distance in the metric [`GaussianFisher`] if both points and the geodesic
    /// between them have `|t| ≤ T`, and `None` for other pairs.
    ///
    /// Below `t = −T`, `e^{−2S}` is at least its value at `−T`, so projecting a curve up to `−T`
    /// makes no piece longer. Above, `S ≤ t` makes `H` at least as large as the Fisher metric (up
    /// to rounding for `t < 0`). So no curve is shorter than the Fisher distance. In the
    /// coordinates `(μ/√2, σ)` the geodesics of the Fisher metric are half-circles about points of
    /// `σ = 0`. A half-circle is lowest at an end of the arc, so only its top decides whether the
    /// arc stays in the strip.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        let (low, high) = (x[1].min(y[1]), x[1].max(y[1]));
        if !(x[1].abs() <= self.rim && y[1].abs() <= self.rim) {
            return None;
        }
        // Measured along a, the centre is at the distance a/2 + (σ₂² − σ₁²)/2a from the lower end.
        // If it lies beyond the upper end, the top is not on the arc.
        let across = (x[0] - y[0]).abs() * FRAC_1_SQRT_2;
        let rise = (2.0 * high).exp() - (2.0 * low).exp();
        let climbs = across * across <= rise;
        let radius = low.exp().hypot(0.5 * across + 0.5 * rise / across);
        if !(climbs || radius <= self.rim.exp()) {
            return None;
        }
        GaussianFisher.distance(x, y)
    }
}
