//! The plane stirred about its origin: the pullback of the Euclidean metric by
//! `Φ(x) = R(α e^{−|x|²/2s²}) x`.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, squarable},
    radial::gaussian,
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H = DΦᵀ DΦ` with `Φ(x) = R(θ) x`, where `R` is the rotation by the angle `θ = α e^{−r²/2s²}`
/// and `r = |x|`:
///
/// ```text
/// H(x) = I + τ (u vᵀ + v uᵀ) + τ² u uᵀ,    τ = r θ′(r) = −α (r/s)² e^{−r²/2s²}
/// ```
///
/// with `u = x/r`, `v = Ju` and the quarter turn `J`. The metric is flat, but neither conformal nor
/// diagonal. Geodesics are the preimages of straight lines.
///
/// Since `|Φ(x)| = |x|`, `Φ` maps every disc and every circle about the origin onto itself, and
/// distances between these sets are Euclidean. Two circles of radii `r ≤ R` about the origin have
/// the distance `R − r`, and so do the disc of radius `r` and the outside of the disc of radius
/// `R`. Every point of the smaller circle, or of the boundary of the disc, has a nearest point on
/// the other set at exactly this distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "twist")]
pub struct Swirl {
    angle: f64,
    width: f64,
    constants: Constants,
}

impl Swirl {
    /// Returns the swirl that turns its centre by the angle `α`, in radians and of either sign, and
    /// has the width `s > 0` in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(angle: f64, width: f64) -> Result<Self, GalleryError> {
        let (a, s) = (finite("angle", angle)?.abs(), squarable("width", width)?);
        // H has determinant 1 and trace 2 + τ², hence the eigenvalues (√(1 + τ²/4) ± |τ|/2)².
        // |τ| = |α| y e^{−y/2} with y = (r/s)² is largest at y = 2.
        let most = 2.0 * a * (-1.0_f64).exp();
        let c2 = ((1.0 + 0.25 * most * most).sqrt() + 0.5 * most).powi(2);
        let l_h = 1.01 * a * (lambda().powi(2) + (kappa() * a).powi(2)).sqrt() / s;
        let m_h = 1.02 * a * (4.0 + (2.25 * a).powi(2)).sqrt() / s / s;
        let constants = Constants::new(1.0 / c2, c2, l_h)?.with_m_h(m_h)?;
        Ok(Self { angle, width, constants })
    }

    /// Returns `R(σ θ(r)) x`, with `σ = ±1`.
    fn turn<S: Scalar>(&self, x: &SVector<S, 2>, sign: f64) -> SVector<S, 2> {
        let (sin, cos) = (gaussian(x, self.width) * (sign * self.angle)).sin_cos();
        vector![cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]]
    }

    /// Returns `Φ(x)`, in `m`. In these coordinates distances are Euclidean.
    pub fn flatten<S: Scalar>(&self, x: &SVector<S, 2>) -> SVector<S, 2> {
        self.turn(x, 1.0)
    }

    /// Returns `Φ⁻¹(y)`, in `ℓ`. Since `|Φ(x)| = |x|`, it is the rotation by the opposite angle.
    pub fn unflatten<S: Scalar>(&self, y: &SVector<S, 2>) -> SVector<S, 2> {
        self.turn(y, -1.0)
    }
}

// Both L_H and M_H are suprema of a form that is the sum of a part linear in α and a quadratic one.
// With s = 1, y = r², e = e^{−y/2}, unit vectors w = c u + σ v and z, and χ/2 the angle between u
// and z,
//
//     zᵀ DH[w] z = α G₁ + α² G₂,        zᵀ D²H[w, w] z = α F₁ + α² F₂,
//
// where, since ∂_v u = v/r and ∂_v v = −u/r,
//
//     G₁ = −√y e ((2 − y) c sin χ − 2σ cos χ),
//     G₂ = y^{3/2} e² ((2 − y) c (1 + cos χ) + σ sin χ).
//
// If G₁²/λ² + G₂²/κ² ≤ q² everywhere, then |α G₁ + α² G₂| ≤ q √(λ² α² + κ² α⁴), by the
// Cauchy–Schwarz inequality. For L_H, λ = max |G₁| and κ = max |G₂| are attained at different
// points and in different directions w, so that q = 1.01 is enough.
//
// For M_H, the part τ (u vᵀ + v uᵀ) is [[−Im f, Re f], [Re f, Im f]] with f = −α ζ² e^{−|ζ|²/2} and
// ζ = x₁ + i x₂. With x on the first axis and w = e^{iω},
//
//     F₁ = e Im(e^{−iχ} (y (y c² − 1) − 4 y c e^{iω} + 2 e^{2iω})),
//     F₂ = e² ((c² (4y³ − 16y² + 10y) + 2y − 2y²) cos² χ/2 + cσ (6y − 4y²) sin χ + 2yσ² sin² χ/2).
//
// Here λ = max |F₁| = 2 (at the centre), and κ = 9/4 is slightly larger than max |F₂| = 2.216…, so
// that q = 1.02 is enough.
//
// Both inequalities are proved by bisection in interval arithmetic for y ≤ 12, in the tests
// `swirl_l_h_is_proven` and `swirl_m_h_is_proven`. For y ≥ 12 they hold with a wide margin:
// |G₁| ≤ 2 y^{3/2} e < 0.21, |G₂| ≤ 2 y^{5/2} e² < 0.01, |F₁| ≤ 2 y² e < 0.72 and
// |F₂| ≤ 5 y³ e² < 0.06, and all of these bounds decrease from there on.

/// Returns `λ = max |G₁| = 2 e^{−1/2}`, attained at `y = 1` and `c = 0`.
fn lambda() -> f64 {
    2.0 * (-0.5_f64).exp()
}

/// Returns `κ = max |G₂|`, attained at `c = 1`, `χ = 0`; `2 y^{3/2} (2 − y) e^{−y}` is stationary
/// where `2y² − 9y + 6 = 0`.
fn kappa() -> f64 {
    let y = 0.25 * (9.0 - 33_f64.sqrt());
    2.0 * y.powf(1.5) * (2.0 - y) * (-y).exp()
}

impl Metric<2> for Swirl {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        // τ u vᵀ = φ x (Jx)ᵀ with φ = τ/r², which does not need a direction u at the centre.
        let phi = gaussian(x, self.width) * (-self.angle / self.width / self.width);
        let weight = phi.sqr() * (x[0].sqr() + x[1].sqr());
        let twist = phi * x[0] * x[1] * 2.0;
        let off = phi * (x[0].sqr() - x[1].sqr()) + weight * x[0] * x[1];
        matrix![
            weight * x[0].sqr() - twist + 1.0, off;
            off, weight * x[1].sqr() + twist + 1.0
        ]
    }
}

impl Bounded<2> for Swirl {
    /// `c₂ = (√(1 + T²/4) + T/2)² = 1/c₁` with `T = 2|α|/e` is attained at `|x| = √2 s`. With
    /// `κ = 2 y^{3/2} (2 − y) e^{−y} = 0.7718…` at `y = (9 − √33)/4`,
    /// `L_H = 1.01 (|α|/s) √(4/e + κ² α²)` and `M_H = 1.02 (|α|/s²) √(4 + 81α²/16)` are upper
    /// bounds, at most 1.02 and 1.05 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for Swirl {
    /// Returns `|Φ(x) − Φ(y)|`.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        Some((self.flatten(x) - self.flatten(y)).norm())
    }
}
