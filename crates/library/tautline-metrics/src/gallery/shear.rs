//! The plane sheared by a wave: the pullback of the Euclidean metric by
//! `Φ(x) = (x₁ + a sin kx₂, x₂)`.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H = JᵀJ = [[1, s], [s, 1 + s²]]` with `J = DΦ`, `s = S cos kx₂` and `S = ak`.
///
/// The metric is flat, but neither conformal nor diagonal. Geodesics are the preimages of straight
/// lines. `Φ` maps each line `{x₂ = c}` and each half-plane `{x₂ ≥ c}` onto itself, so distances to
/// these sets are known too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shear {
    amplitude: f64,
    wave_number: f64,
    constants: Constants,
}

impl Shear {
    /// Returns the shear with amplitude `a` in `ℓ`, of either sign, and wave number `k > 0` in
    /// `1/ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(amplitude: f64, wave_number: f64) -> Result<Self, GalleryError> {
        let k = positive("wave number", wave_number)?;
        let slope = finite("amplitude", amplitude)?.abs() * k;
        // H has determinant 1 and trace 2 + s², hence the eigenvalues (√(1 + s²/4) ± |s|/2)². We
        // compute c₁ as 1/c₂ rather than as the difference, which cancels.
        let c2 = ((1.0 + 0.25 * slope * slope).sqrt() + 0.5 * slope).powi(2);
        // DH[w] = w₂ s′ [[0, 1], [1, 2s]] has the norm |w₂ s′| (|s| + √(1 + s²)), where
        // s′² = k² (S² − s²). With |s| = sinh u, the square of the norm is k² (S² − sinh²
        // u) e^{2u}, which is stationary where S² = sinh u (sinh u + cosh u), that is,
        // e^{2u} = 1 + 2S². There it is
        // k² sinh u cosh u e^{2u} = k² (e^{4u} − 1)/4 = k² S² (1 + S²).
        let root = slope * (1.0 + slope * slope).sqrt();
        // D²H[w, w] = w₂² k² [[0, −s], [−s, q]] with q = 2S² − 4s² has the norm
        // w₂² k² (|q|/2 + √(q²/4 + s²)). It is largest at s² = S², where both |q| and s² are
        // largest.
        let m_h = k * k * (slope * slope + root);
        let constants = Constants::new(1.0 / c2, c2, k * root)?.with_m_h(m_h)?;
        Ok(Self { amplitude, wave_number, constants })
    }

    /// Returns `Φ(x)`, in `m`. In these coordinates distances are Euclidean.
    pub fn flatten<S: Scalar>(&self, x: &SVector<S, 2>) -> SVector<S, 2> {
        vector![x[0] + (x[1] * self.wave_number).sin() * self.amplitude, x[1]]
    }

    /// Returns `Φ⁻¹(y)`, in `ℓ`.
    pub fn unflatten<S: Scalar>(&self, y: &SVector<S, 2>) -> SVector<S, 2> {
        vector![y[0] - (y[1] * self.wave_number).sin() * self.amplitude, y[1]]
    }
}

impl Metric<2> for Shear {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let s = (x[1] * self.wave_number).cos() * (self.amplitude * self.wave_number);
        matrix![S::one(), s; s, s.sqr() + 1.0]
    }
}

impl Bounded<2> for Shear {
    /// All constants are attained: `c₂ = (√(1 + S²/4) + |S|/2)² = 1/c₁`, `L_H = k|S| √(1 + S²)` and
    /// `M_H = k² (S² + |S| √(1 + S²))`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for Shear {
    /// Returns `|Φ(x) − Φ(y)|`.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        Some((self.flatten(x) - self.flatten(y)).norm())
    }
}
