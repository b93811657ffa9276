//! Corrugated iron: the cylindrical surface over `f(x₁) = a sin kx₁`.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric, quadrature::integrate};

/// `H(x) = I + f′(x₁)² e₁e₁ᵀ` with `f = a sin kx₁`, in any dimension: the metric of the graph of
/// `f` in `R^{D+1}`, which is a bent sheet.
///
/// The metric is flat: with the arc length `s(x₁) = ∫₀ √(1 + f′²)` it is the pullback of the
/// Euclidean metric by `(s(x₁), x₂, …)`. This map takes boxes to boxes and half-spaces `{xᵢ ≥ c}`
/// to half-spaces, so the distances between these sets are known too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrugated {
    amplitude: f64,
    wave_number: f64,
    /// The arc length over half a wave, `π/k`.
    half_wave: f64,
    constants: Constants,
}

impl Corrugated {
    /// Returns the sheet with amplitude `a` in `ℓ`, of either sign, and wave number `k > 0` in
    /// `1/ℓ` (here `m` is the same as `ℓ`, the unit of the coordinates).
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(amplitude: f64, wave_number: f64) -> Result<Self, GalleryError> {
        let k = positive("wave number", wave_number)?;
        let slope2 = (finite("amplitude", amplitude)? * k).powi(2);
        // f′² = a²k² cos² kx₁ = ½ a²k² (1 + cos 2kx₁).
        let constants =
            Constants::new(1.0, 1.0 + slope2, slope2 * k)?.with_m_h(2.0 * slope2 * k * k)?;
        let mut sheet = Self { amplitude, wave_number, half_wave: 0.0, constants };
        sheet.half_wave = sheet.piece(0.0, PI / k);
        Ok(sheet)
    }

    /// Returns the arc length from `a` to `b`, which are at most half a wave apart.
    fn piece(&self, a: f64, b: f64) -> f64 {
        let slope = self.amplitude * self.wave_number;
        integrate(|x| (slope * (self.wave_number * x).cos()).hypot(1.0), a, b, 1e-15).value
    }

    /// Returns `|s(b) − s(a)|`, in `m`: the arc length of `f` between `a` and `b`.
    #[must_use]
    pub fn arc_length(&self, a: f64, b: f64) -> f64 {
        let (low, high) = (a.min(b), a.max(b));
        // √(1 + f′²) has the period π/k. We count whole periods instead of integrating over them.
        let period = PI / self.wave_number;
        let whole = ((high - low) / period).floor();
        whole * self.half_wave + self.piece(low + whole * period, high)
    }
}

impl<const D: usize> Metric<D> for Corrugated {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let slope = (x[0] * self.wave_number).cos() * (self.amplitude * self.wave_number);
        let mut h = SMatrix::<S, D, D>::identity();
        h[(0, 0)] += slope.sqr();
        h
    }
}

impl<const D: usize> Bounded<D> for Corrugated {
    /// All constants are attained: `c₁ = 1` and `c₂ = 1 + a²k²` where `cos kx₁` is 0 and 1,
    /// `L_H = a²k³` where `sin 2kx₁ = 1`, and `M_H = 2a²k⁴` where `cos 2kx₁ = 1`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for Corrugated {
    /// Returns `√((s(x₁) − s(y₁))² + (x₂ − y₂)² + …)`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let along = self.arc_length(x[0], y[0]);
        Some((1..D).map(|i| x[i] - y[i]).fold(along, f64::hypot))
    }
}
