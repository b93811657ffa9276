//! An anisotropy that rotates in space: `H(x) = Q(k·x) diag(λ₁, λ₂) Q(k·x)ᵀ`.

use nalgebra::{SMatrix, SVector, matrix};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, positive},
};
use crate::{Bounded, Constants, Metric};

/// `H(x) = Q(θ) diag(λ₁, λ₂) Q(θ)ᵀ` in the plane, where `Q` is the rotation by the angle `θ = k·x`.
/// The eigenvalues are constant, and their directions turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotatingAnisotropy {
    eigenvalues: [f64; 2],
    wave_vector: SVector<f64, 2>,
    constants: Constants,
}

impl RotatingAnisotropy {
    /// Returns the metric with the eigenvalues `λ₁, λ₂ > 0` in `m²/ℓ²`, in either order, and
    /// the wave vector `k` in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(
        eigenvalues: [f64; 2],
        wave_vector: impl Into<SVector<f64, 2>>,
    ) -> Result<Self, GalleryError> {
        let wave_vector = wave_vector.into();
        let [first, second] = eigenvalues;
        positive("eigenvalue", first)?;
        positive("eigenvalue", second)?;
        for &entry in &wave_vector {
            finite("entry of the wave vector", entry)?;
        }
        // H = ½ (λ₁ + λ₂) I + ½ (λ₁ − λ₂) R(2θ) with the reflection R = [[cos, sin], [sin, −cos]].
        // R′ and R″ are orthogonal, so DH[w] and D²H[w, w] have the norms |λ₁ − λ₂| |k·w| and
        // 2 |λ₁ − λ₂| (k·w)² at every point.
        let (difference, k) = ((first - second).abs(), wave_vector.norm());
        let constants = Constants::new(first.min(second), first.max(second), difference * k)?
            .with_m_h(2.0 * difference * k * k)?;
        Ok(Self { eigenvalues, wave_vector, constants })
    }
}

impl Metric<2> for RotatingAnisotropy {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let [first, second] = self.eigenvalues;
        // Where one eigenvalue is much smaller than the other, it is lost in a sum that is rounded; so
        // the sums are steps of the formula, which intervals enclose.
        let [first, second] = [first, second].map(S::constant);
        let (mean, half) = ((first + second) * 0.5, (first - second) * 0.5);
        let (sin, cos) =
            (x[0] * (2.0 * self.wave_vector[0]) + x[1] * (2.0 * self.wave_vector[1])).sin_cos();
        let off = sin * half;
        matrix![cos * half + mean, off; off, -cos * half + mean]
    }
}

impl Bounded<2> for RotatingAnisotropy {
    /// `c₁ = min(λ₁, λ₂)`, `c₂ = max(λ₁, λ₂)`, `L_H = |λ₁ − λ₂| |k|` and `M_H = 2 |λ₁ − λ₂| |k|²`
    /// are attained at every point.
    fn constants(&self) -> Constants {
        self.constants
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_scalar::Interval;

    use super::RotatingAnisotropy;
    use crate::Metric;

    /// In `f64` half the sum of `10⁸` and 0.1 minus half their difference is 0.09999999403953552.
    #[test]
    fn the_smaller_eigenvalue_is_enclosed() {
        let metric = RotatingAnisotropy::new([1e8, 0.1], [0.0, 0.0]).expect("positive");
        let h = metric.gram(&SVector::from([Interval::point(0.5); 2]));
        assert!(h[(1, 1)].lo() < 0.1 && 0.1 < h[(1, 1)].hi(), "{:?}", h[(1, 1)]);
        assert!(h[(1, 1)].width() < 1e-7, "{:?}", h[(1, 1)]);
    }
}
