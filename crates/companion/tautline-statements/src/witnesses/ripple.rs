//! `Ripple`: a constant metric with a wave in one pair of entries.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

use crate::VerifyError;

/// `H = c I + (L/k) sin(k xₗ) E`, where `E` has a 1 at `(i, j)` and at `(j, i)`, and `k = 2L/c`.
///
/// Since `‖E‖ = 1`, `‖H(x) − H(y)‖ ≤ L |xₗ − yₗ|`. Where `xₗ = 0`, `∂ₗ Hᵢⱼ = L`, which attains
/// Proposition 7.10.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ripple<const D: usize> {
    base: f64,
    slope: f64,
    entry: [usize; 2],
    direction: usize,
}

impl<const D: usize> Ripple<D> {
    /// Returns the ripple of the entry `[i, j]` along `x_l`, where `l = direction`, `c = base > 0`
    /// in `m²/ℓ²`, and `L = slope > 0` in `m²/ℓ³`. All indices are taken modulo `D`.
    ///
    /// # Errors
    ///
    /// [`VerifyError::OutOfRange`] unless `base` and `slope` are positive and finite.
    pub fn new(
        base: f64,
        slope: f64,
        [i, j]: [usize; 2],
        direction: usize,
    ) -> Result<Self, VerifyError> {
        for (name, value) in [("base", base), ("slope", slope)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(VerifyError::OutOfRange { name, value, low: 0.0, high: f64::MAX });
            }
        }
        Ok(Self { base, slope, entry: [i % D, j % D], direction: direction % D })
    }
}

impl<const D: usize> Metric<D> for Ripple<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let k = 2.0 * self.slope / self.base;
        let wave = (x[self.direction] * k).sin() * (0.5 * self.base);
        let mut h = SMatrix::from_diagonal_element(S::constant(self.base));
        let [i, j] = self.entry;
        h[(i, j)] += wave;
        if i != j {
            h[(j, i)] += wave;
        }
        h
    }
}

impl<const D: usize> Bounded<D> for Ripple<D> {
    /// `c₁ = c/2`, `c₂ = 3c/2`, `L_H = L`.
    fn constants(&self) -> Constants {
        Constants::new(0.5 * self.base, 1.5 * self.base, self.slope).expect("positive")
    }
}
