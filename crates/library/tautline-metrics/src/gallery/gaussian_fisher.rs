//! The Fisher metric of normal distributions, `H = diag(e^{−2t}, 2)`, in terms of the mean and the
//! logarithm of the standard deviation.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::{Constants, KnownDistance, LocalError, LocallyBounded, Metric};

/// `H(μ, t) = diag(e^{−2t}, 2)`: the Fisher metric of the normal distributions with mean `μ` and
/// standard deviation `σ = e^t`, that is `(dμ² + 2 dσ²)/σ²`. All numbers are pure.
///
/// The metric has constants on every ball, but not on the whole plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "information geometry")]
pub struct GaussianFisher;

impl Metric<2> for GaussianFisher {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal(&SVector::from([(x[1] * -2.0).exp(), S::constant(2.0)]))
    }
}

impl LocallyBounded<2> for GaussianFisher {
    /// All constants are exact: `c₁ = min(e^{−2t}, 2)` at the top of the ball;
    /// `c₂ = max(e^{−2t}, 2)`, `L_H = 2 e^{−2t}` and `M_H = 4 e^{−2t}` at its bottom.
    fn constants_within(
        &self,
        centre: &SVector<f64, 2>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        LocalError::check_ball(centre.as_slice(), radius)?;
        let information = |t: f64| (-2.0 * t).exp();
        let (least, most) = (information(centre[1] + radius), information(centre[1] - radius));
        let constants = Constants::new(least.min(2.0), most.max(2.0), 2.0 * most)?;
        Ok(constants.with_m_h(4.0 * most)?.on_a_region())
    }
}

impl KnownDistance<2> for GaussianFisher {
    /// Returns
    /// `√2 arcosh(1 + ((Δμ)²/2 + (Δσ)²) / (2σσ′)) = 2√2 arsinh √(sinh²(Δt/2) + (Δμ)²/(8σσ′))`, for
    /// all pairs. In the coordinates `(μ/√2, σ)` it is `√2` times the hyperbolic distance of the
    /// upper half-plane.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        let across = (x[0] - y[0]).abs() * FRAC_1_SQRT_2;
        let (half, mean) = (0.5 * (x[1] - y[1]), 0.5 * (x[1] + y[1]));
        Some(2.0 * SQRT_2 * half.sinh().hypot(0.5 * across * (-mean).exp()).asinh())
    }
}
