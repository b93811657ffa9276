//! Rank-one ridges in several directions: `H(x) = I + ½ Σ sin²(wₖ·x) aₖ aₖᵀ`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use super::{GalleryError, eigenvalues::eigenvalue_bounds, error::finite};
use crate::{Bounded, Constants, Metric};

/// One term `½ sin²(w·x) a aᵀ` of [`SineProjections`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineProjection<const D: usize> {
    /// The wave vector `w`, in `1/ℓ`.
    pub wave_vector: SVector<f64, D>,
    /// The direction `a` in which the term adds to the cost, in `m/ℓ`.
    pub direction: SVector<f64, D>,
}

/// `H(x) = I + ½ Σₖ sin²(wₖ·x) aₖ aₖᵀ`, with any number of terms, in any dimension. It is a full
/// matrix that costs `D²` multiplications per term.
#[derive(Clone, Debug, PartialEq)]
pub struct SineProjections<const D: usize> {
    terms: Vec<SineProjection<D>>,
    constants: Constants,
}

impl<const D: usize> SineProjections<D> {
    /// Returns the metric with the given terms.
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with an entry that is not finite, or with the constant that overflows.
    pub fn new(terms: Vec<SineProjection<D>>) -> Result<Self, GalleryError> {
        let mut sum = SMatrix::<f64, D, D>::zeros();
        let mut longest = 0.0_f64;
        for term in &terms {
            for &entry in &term.wave_vector {
                finite("entry of a wave vector", entry)?;
            }
            for &entry in &term.direction {
                finite("entry of a direction", entry)?;
            }
            sum += term.direction * term.direction.transpose();
            longest = longest.max(term.wave_vector.norm());
        }
        let (_, most) = eigenvalue_bounds(&sum);
        // With θₖ = wₖ·x, |uᵀ DH[w] u| = ½ |Σ sin 2θₖ (wₖ·w)(aₖ·u)²| ≤ ½ max |wₖ| Σ (aₖ·u)², and
        // |uᵀ D²H[w, w] u| = |Σ cos 2θₖ (wₖ·w)² (aₖ·u)²| ≤ max |wₖ|² Σ (aₖ·u)².
        let constants = Constants::new(1.0, 1.0 + 0.5 * most, 0.5 * longest * most)?
            .with_m_h(longest * longest * most)?;
        Ok(Self { terms, constants })
    }
}

impl SineProjections<8> {
    /// Returns the instance that the benchmarks use: `D = 8` with eight terms,
    /// `aₖ[i] = ½ cos(1.3 k i)` and `wₖ[i] = sin(0.7 k + i)` for `k, i = 1, …, 8`.
    ///
    /// By the addition theorem its wave vectors span a plane, so it is constant in the other six
    /// dimensions.
    #[must_use]
    pub fn benchmark() -> Self {
        let term = |k: f64| SineProjection {
            wave_vector: SVector::from_fn(|i, _| (0.7 * k + (i + 1) as f64).sin()),
            direction: SVector::from_fn(|i, _| 0.5 * (1.3 * k * (i + 1) as f64).cos()),
        };
        Self::new((1..=8).map(|k| term(f64::from(k))).collect()).expect("entries of size 1")
    }
}

/// Returns `w·x`.
#[inline]
fn phase<S: Scalar, const D: usize>(w: &SVector<f64, D>, x: &SVector<S, D>) -> S {
    let mut phase = S::zero();
    for i in 0..D {
        phase += x[i] * w[i];
    }
    phase
}

impl<const D: usize> Metric<D> for SineProjections<D> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = SMatrix::<S, D, D>::identity();
        for SineProjection { wave_vector: w, direction: a } in &self.terms {
            let weight = phase(w, x).sin().sqr() * 0.5;
            for j in 0..D {
                for i in 0..=j {
                    h[(i, j)] += weight * (a[i] * a[j]);
                }
            }
        }
        h.fill_lower_triangle_with_upper_triangle();
        h
    }
}

impl<const D: usize> Bounded<D> for SineProjections<D> {
    /// `c₁ = 1` at `x = 0`. With `λ` the greatest eigenvalue of `Σ aₖ aₖᵀ`, `c₂ = 1 + ½ λ`,
    /// `L_H = ½ λ max |wₖ|` and `M_H = λ max |wₖ|²` are upper bounds, which a single term attains.
    fn constants(&self) -> Constants {
        self.constants
    }
}
