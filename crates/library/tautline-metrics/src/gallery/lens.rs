//! A graded-index lens: `H(x) = (1 + a e^{−|x|²/2s²}) I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{nonnegative, squarable},
    radial::{along_ray, gaussian},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = n² I` with the squared index `n² = 1 + a e^{−|x|²/2s²}`, in any dimension.
///
/// If `a` is large enough, two points on opposite sides of the centre have two minimal geodesics,
/// one around each side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    height: f64,
    width: f64,
    constants: Constants,
}

impl Lens {
    /// Returns the lens of height `a ≥ 0` in `m²/ℓ²` and width `s > 0` in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(height: f64, width: f64) -> Result<Self, GalleryError> {
        let (a, s) = (nonnegative("height", height)?, squarable("width", width)?);
        // With ρ = |x|/s: |∇n²| = (a/s) ρ e^{−ρ²/2} is largest at ρ = 1. The second derivative of
        // n² is (a/s²) e^{−ρ²/2} times ρ² − 1 along the ray and times −1 across it. Both are
        // largest in absolute value at ρ = 0.
        let l_h = a / s * (-0.5_f64).exp();
        let constants = Constants::new(1.0, 1.0 + a, l_h)?.with_m_h(a / s / s)?.isotropic();
        Ok(Self { height, width, constants })
    }
}

impl<const D: usize> Metric<D> for Lens {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal_element(gaussian(x, self.width) * self.height + 1.0)
    }
}

impl<const D: usize> Bounded<D> for Lens {
    /// `c₁ = 1` holds in the limit; `c₂ = 1 + a`, `L_H = (a/s) e^{−1/2}` and `M_H = a/s²` are
    /// attained.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for Lens {
    /// Returns `∫ n` along the ray for two points on one ray from the centre, and `None` for other
    /// pairs.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let n = |r: f64| (self.height * (-0.5 * (r / self.width).powi(2)).exp() + 1.0).sqrt();
        along_ray(x, y, self.width, n)
    }
}
