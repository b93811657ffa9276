//! A ramp on the line: `H(x) = (1 + a tanh kx)²`.

use std::f64::consts::LN_2;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{below_one, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric};

/// `H(x) = f²` with `f = 1 + a tanh kx`, on the line. The cost is `1 − a` far to the left and
/// `1 + a` far to the right.
///
/// Every metric on the line is flat, and its distance is an integral. Unlike the periodic metrics,
/// this one has no symmetry that could make a leading error constant vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    amplitude: f64,
    wave_number: f64,
    constants: Constants,
}

impl Ramp {
    /// Returns the ramp with relative amplitude `a`, `|a| < 1`, and steepness `k > 0` in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(amplitude: f64, wave_number: f64) -> Result<Self, GalleryError> {
        let a = below_one("amplitude", amplitude)?.abs();
        let k = positive("wave number", wave_number)?;
        // |H′| = 2|a|k (1 + |a|τ)(1 − τ²) with τ = ± tanh kx is stationary where
        // 3|a|τ² + 2τ − |a| = 0. This is the root in [0, 1), written without cancellation at a = 0:
        let tau = a / (1.0 + (1.0 + 3.0 * a * a).sqrt());
        let l_h = 2.0 * a * k * (1.0 + a * tau) * (1.0 - tau * tau);
        // H″ = 2ak² (−2τ(1 − τ²) + a (1 − τ²)(1 − 3τ²)): the first term in the bracket is at most
        // 4/(3√3) (at τ² = 1/3), and the second at most |a| (at τ = 0).
        let m_h = 2.0 * a * k * k * (4.0 / 27_f64.sqrt() + a);
        let constants =
            Constants::new((1.0 - a).powi(2), (1.0 + a).powi(2), l_h)?.with_m_h(m_h)?.isotropic();
        Ok(Self { amplitude, wave_number, constants })
    }

    /// Returns the `F` with `F′ = f` and `F(0) = 0`.
    fn primitive(&self, x: f64) -> f64 {
        x + self.amplitude / self.wave_number * ln_cosh(self.wave_number * x)
    }
}

/// Returns `ln cosh u`, without overflow in `cosh`.
fn ln_cosh(u: f64) -> f64 {
    u.abs() + (-2.0 * u.abs()).exp().ln_1p() - LN_2
}

impl Metric<1> for Ramp {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let f = (x[0] * self.wave_number).tanh() * self.amplitude + 1.0;
        SMatrix::from_diagonal_element(f.sqr())
    }
}

impl Bounded<1> for Ramp {
    /// `c₁ = (1 − |a|)²` and `c₂ = (1 + |a|)²` hold in the limit; `L_H = 2|a|k (1 + |a|τ)(1 − τ²)`
    /// is attained at `τ = |a| / (1 + √(1 + 3a²))`; `M_H = 2|a|k² (4/√27 + |a|)` is an upper bound,
    /// at most 1.5 times too large.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<1> for Ramp {
    /// Returns `|F(x) − F(y)|` with `F(x) = x + (a/k) ln cosh kx`.
    fn distance(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> Option<f64> {
        Some((self.primitive(x[0]) - self.primitive(y[0])).abs())
    }
}
