//! The vertex test: a bound on `pᵀH⁻¹p` over a simplex from its vertices.
//!
//! Let `p` be affine on a simplex `T` whose vertices are corners of a cube of side `a` and centre `c`,
//! and `uᵀD²H[e,e]u ≤ Σ Mₖ eₖ²` on the cube for all vectors `e` and unit vectors `u`, with `Mₖ ≥ 0`.
//! Put `ε = Σ Mₖ a²/8` and `Sᵢ = H(vᵢ) − ε I`, and let all `Sᵢ` be positive definite. Then
//!
//! ```text
//! max_T pᵀH⁻¹p ≤ maxᵢ p(vᵢ)ᵀ Sᵢ⁻¹ p(vᵢ).
//! ```
//!
//! This is Lemma V of `paper/CERTIFICATE.md`, which proves it.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::rounding::{add_up, mul_up};

/// Returns `H` at a point or on a box; the entries above the diagonal define it.
pub(crate) fn gram<const D: usize>(
    formula: &Formula<D>,
    x: &SVector<Interval, D>,
) -> SMatrix<Interval, D, D> {
    symmetric(&formula.gram(x))
}

/// Returns the matrix with the entries on and above the diagonal.
pub(crate) fn symmetric<S: Scalar, const D: usize>(h: &SMatrix<S, D, D>) -> SMatrix<S, D, D> {
    SMatrix::from_fn(|i, j| h[(i.min(j), i.max(j))])
}

/// Returns a `C ≥ 0` such that `uᵀD²H[e,e]u ≤ Σ Mₖ eₖ²` for some `Mₖ ≥ 0` with `Σ Mₖ ≤ C`, for all
/// points of a box, all vectors `e` and all unit vectors `u`; NaN if `H` is not proved to be twice
/// differentiable there.
///
/// The form is that of the symmetric `D² × D²` matrix `∂ₖ∂ₗHᵢⱼ` (rows `ik`, columns `jl`) at `u ⊗ e`.
/// Let `Rᵢₖ` be the sum of the diagonal entry and the magnitudes of the others in a row. Since
/// `2yz ≤ y² + z²`, the form is at most `Σ Rᵢₖ uᵢ²eₖ²`, so that `Mₖ = maxᵢ Rᵢₖ` will do. So will the
/// Frobenius norm for all `Mₖ`.
pub(crate) fn curvature<const D: usize>(formula: &Formula<D>, cube: &SVector<Interval, D>) -> f64 {
    let coordinates: [Interval; D] = std::array::from_fn(|i| cube[i]);
    let h = symmetric(&formula.gram(&SVector::from(Jet2::variables(&coordinates))));
    let mut squares = Interval::point(0.0);
    let mut along = [0.0_f64; D];
    for (i, k) in (0..D * D).map(|row| (row / D, row % D)) {
        let mut row = Interval::point(0.0);
        for (j, l) in (0..D * D).map(|column| (column / D, column % D)) {
            let second = h[(i, j)].second(k, l);
            if !second.is_finite() {
                return f64::NAN;
            }
            squares += second.sqr();
            row += if (i, k) == (j, l) { second } else { Interval::point(second.magnitude()) };
        }
        along[k] = along[k].max(row.hi());
    }
    let sum = along.into_iter().fold(0.0, add_up);
    sum.min(mul_up(squares.sqrt().hi(), D as f64))
}

/// `S = H − ε I` at a corner, decomposed as `L Δ Lᵀ`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decomposed<const D: usize> {
    /// `L` below the diagonal, `1/δ` on it.
    factors: SMatrix<Interval, D, D>,
}

impl<const D: usize> Decomposed<D> {
    /// Returns the decomposition; `None` if a pivot is not proved to be positive.
    pub(crate) fn new(mut s: SMatrix<Interval, D, D>, shift: Interval) -> Option<Self> {
        for i in 0..D {
            s[(i, i)] -= shift;
        }
        for k in 0..D {
            let pivot = s[(k, k)];
            if !(pivot.lo() > 0.0) {
                return None;
            }
            for i in k + 1..D {
                let factor = s[(i, k)] / pivot;
                for j in k + 1..=i {
                    let entry = s[(i, j)] - factor * s[(j, k)];
                    s[(i, j)] = entry;
                }
            }
            // The rows below need the entries before the division.
            for i in k + 1..D {
                s[(i, k)] /= pivot;
            }
            s[(k, k)] = pivot.recip();
        }
        Some(Self { factors: s })
    }

    /// Returns an upper bound on `pᵀS⁻¹p = Σ yᵢ²/δᵢ` with `L y = p`.
    pub(crate) fn inverse_square(&self, p: &[Interval; D]) -> f64 {
        let mut y = *p;
        let mut sum = Interval::point(0.0);
        for i in 0..D {
            for j in 0..i {
                y[i] -= self.factors[(i, j)] * y[j];
            }
            sum += y[i].sqr() * self.factors[(i, i)];
        }
        // An unknown square is no bound.
        if sum.is_undefined() { f64::INFINITY } else { sum.hi() }
    }
}

#[cfg(test)]
mod tests;
