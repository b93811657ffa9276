//! A wave along each axis: `H(x) = diag(fᵢ(xᵢ)²)` with `fᵢ = 1 + aᵢ sin kᵢxᵢ`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{below_one, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = diag(fᵢ²)` with `fᵢ = 1 + aᵢ sin kᵢxᵢ`, in any dimension: the pullback of the
/// Euclidean metric by `F(x) = (F₁(x₁), …)` with `Fᵢ′ = fᵢ`.
///
/// `F` increases in each coordinate, so it maps boxes to boxes and half-spaces `{xᵢ ≥ c}` to
/// half-spaces. The distances between these sets are therefore known too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separable<const D: usize> {
    amplitudes: SVector<f64, D>,
    wave_numbers: SVector<f64, D>,
    constants: Constants,
}

impl<const D: usize> Separable<D> {
    /// Returns the metric with relative amplitudes `|aᵢ| < 1` and wave numbers `kᵢ > 0` in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(
        amplitudes: impl Into<SVector<f64, D>>,
        wave_numbers: impl Into<SVector<f64, D>>,
    ) -> Result<Self, GalleryError> {
        let (amplitudes, wave_numbers) = (amplitudes.into(), wave_numbers.into());
        let (mut c1, mut c2) = (f64::INFINITY, 0.0_f64);
        let (mut l_h, mut m_h) = (0.0_f64, 0.0_f64);
        for (&a, &k) in amplitudes.iter().zip(&wave_numbers) {
            let a = below_one("amplitude", a)?.abs();
            let k = positive("wave number", k)?;
            c1 = c1.min((1.0 - a).powi(2));
            c2 = c2.max((1.0 + a).powi(2));
            // |(f²)′| = 2|a|k (1 + |a|s) √(1 − s²) with s = ± sin kx is stationary where
            // 2|a|s² + s − |a| = 0. This is the root in [0, 1), written without cancellation at
            // a = 0:
            let s = 2.0 * a / (1.0 + (1.0 + 8.0 * a * a).sqrt());
            l_h = l_h.max(2.0 * a * k * (1.0 + a * s) * (1.0 - s * s).sqrt());
            // (f²)″ = 2k² (a² − |a|s − 2a²s²) is a parabola in s. At s = 1 it is −2k² (|a| + a²).
            // Its absolute value at s = −1 is smaller. At its vertex s = −1/(4|a|), if |s| ≤ 1
            // there, it is 2k² (a² + 1/8), and 1/8 < 1/4 ≤ |a|.
            m_h = m_h.max(2.0 * k * k * (a + a * a));
        }
        // The matrices DH[w] and D²H[w, w] are diagonal, so their norm is their largest entry. It
        // is largest for w along one axis.
        let constants = Constants::new(c1, c2, l_h)?.with_m_h(m_h)?;
        Ok(Self { amplitudes, wave_numbers, constants })
    }

    /// Returns `F(x)`, in `m`, with `Fᵢ(xᵢ) = xᵢ + (aᵢ/kᵢ)(1 − cos kᵢxᵢ)`. In these coordinates
    /// distances are Euclidean.
    pub fn flatten<S: Scalar>(&self, x: &SVector<S, D>) -> SVector<S, D> {
        SVector::from_fn(|i, _| {
            let (a, k) = (self.amplitudes[i], self.wave_numbers[i]);
            x[i] + (-(x[i] * k).cos() + 1.0) * (a / k)
        })
    }
}

impl<const D: usize> Metric<D> for Separable<D> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal(&SVector::<S, D>::from_fn(|i, _| {
            ((x[i] * self.wave_numbers[i]).sin() * self.amplitudes[i] + 1.0).sqr()
        }))
    }
}

impl<const D: usize> Bounded<D> for Separable<D> {
    /// All constants are attained: `c₁ = min (1 − |aᵢ|)²`, `c₂ = max (1 + |aᵢ|)²`,
    /// `L_H = max 2|aᵢ|kᵢ (1 + |aᵢ|s) √(1 − s²)` at `s = 2|aᵢ| / (1 + √(1 + 8aᵢ²))`, and
    /// `M_H = max 2kᵢ² (|aᵢ| + aᵢ²)`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for Separable<D> {
    /// Returns `|F(x) − F(y)|`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        Some((self.flatten(x) - self.flatten(y)).norm())
    }
}
