//! An isotropic bump: `H(x) = (1 + a e^{−|x|²/2s²})² I`.

use std::f64::consts::FRAC_1_SQRT_2;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{nonnegative, squarable},
    radial::{along_ray, gaussian},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = f² I` with `f = 1 + a e^{−|x|²/2s²}`, in any dimension; `f` is the cost per unit length.
///
/// For `a = 4`, `s = 1/2` the straight line from `(−1.5, 0.05)` to `(1.5, −0.1)` is close to a
/// geodesic with almost three times the energy of the minimal geodesic, which goes around the bump.
/// This makes the metric a test for optimizers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    height: f64,
    width: f64,
    constants: Constants,
}

impl Bump {
    /// Returns the bump of height `a ≥ 0` in `m/ℓ` and width `s > 0` in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(height: f64, width: f64) -> Result<Self, GalleryError> {
        let (a, s) = (nonnegative("height", height)?, squarable("width", width)?);
        // With ρ = |x|/s: |∇f²| = (2a/s) (ρ e^{−ρ²/2} + a ρ e^{−ρ²}) is at most the sum of the
        // maxima e^{−1/2} (at ρ = 1) and a e^{−1/2}/√2 (at ρ² = 1/2).
        let l_h = 2.0 * a / s * (-0.5_f64).exp() * (1.0 + a * FRAC_1_SQRT_2);
        // With y = ρ², g = e^{−y/2} and the radial part c of a unit vector w, D²(f²)[w,
        // w] = (2a/s²) g (c² y (1 + 2ag) − (1 + ag)). It is at least its value for c = 0,
        // −(2a/s²) g (1 + ag), which is −(2a/s²)(1 + a) at the centre. It is at most its value for
        // c = 1, (2a/s²) (g (y − 1) + a g² (2y − 1)) ≤ (2a/s²) 2e^{−3/2} (1 + a).
        let m_h = 2.0 * a / s / s * (1.0 + a);
        let constants = Constants::new(1.0, (1.0 + a).powi(2), l_h)?.with_m_h(m_h)?.isotropic();
        Ok(Self { height, width, constants })
    }
}

impl<const D: usize> Metric<D> for Bump {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal_element((gaussian(x, self.width) * self.height + 1.0).sqr())
    }
}

impl<const D: usize> Bounded<D> for Bump {
    /// `c₁ = 1` holds in the limit; `c₂ = (1 + a)²` and `M_H = 2a (1 + a)/s²` are attained at the
    /// centre; `L_H = (2a/s) e^{−1/2} (1 + a/√2)` is an upper bound, at most 1.04 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl<const D: usize> KnownDistance<D> for Bump {
    /// Returns `∫ f` along the ray for two points on one ray from the centre, and `None` for other
    /// pairs.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let f = |r: f64| self.height * (-0.5 * (r / self.width).powi(2)).exp() + 1.0;
        along_ray(x, y, self.width, f)
    }
}
