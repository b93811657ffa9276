//! `Zigzag`: a metric on the line with a valley or a ridge at the middle of each chord.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// `H = c + s |x − m|`, where `m` is the nearest of the points `(k + ½)/N`. There are V-shaped
/// valleys for `s > 0` and ridges for `s < 0`, one in each of `N` steps along `[0, 1]`.
///
/// It is the limit of smooth metrics with the same `L_H = |s|`. It is not differentiable at the
/// tips, so only its values are of use. If `[0, 1]` is divided into `N` equal chords, the
/// trapezoidal rule evaluates `H` only at the tips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zigzag {
    tip: f64,
    slope: f64,
    n: f64,
    constants: Constants,
}

impl Zigzag {
    /// Returns the zigzag with `H = tip` at the points `(k + ½)/n` and the slopes `±slope`, in
    /// `m²/ℓ²` and `m²/ℓ³`; `None` unless it is positive.
    #[must_use]
    pub fn new(tip: f64, slope: f64, n: usize) -> Option<Self> {
        let foot = tip + 0.5 * slope / n as f64;
        let constants = Constants::new(tip.min(foot), tip.max(foot), slope.abs()).ok()?;
        Some(Self { tip, slope, n: n as f64, constants })
    }
}

impl Metric<1> for Zigzag {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        // atan ∘ tan is the signed distance to the nearest multiple of π.
        let angle = ((x[0] * self.n - 0.5) * PI).tan().atan();
        let distance = angle.sqr().sqrt() / (PI * self.n);
        SMatrix::from_diagonal_element(distance * self.slope + self.tip)
    }
}

impl Bounded<1> for Zigzag {
    /// `H` lies between its values at the tips and at the feet, and `L_H = |slope|`.
    fn constants(&self) -> Constants {
        self.constants
    }
}
