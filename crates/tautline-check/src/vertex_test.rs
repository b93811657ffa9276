//! The vertex test: a bound on `pᵀH⁻¹p` over a simplex from its vertices.
//!
//! Let `p` be affine on a simplex `T` in a ball about `c` of radius `R`, and `uᵀD²H[e,e]u ≤ M` for
//! all unit vectors `e`, `u`, with `M ≥ 0`. Put `ε = M R²/2` and `Sᵢ = H(vᵢ) − ε I`, and let all
//! `Sᵢ` be positive definite. Then
//!
//! ```text
//! max_T pᵀH⁻¹p ≤ maxᵢ p(vᵢ)ᵀ Sᵢ⁻¹ p(vᵢ).
//! ```
//!
//! Proof. For a unit vector `u`, the function `uᵀHu − M|x − c|²/2` is concave on `T`. So at
//! `x = Σ λᵢ vᵢ` the form `uᵀH(x)u` is at least `Σ λᵢ uᵀH(vᵢ)u − ε = uᵀSu` with `S = Σ λᵢ Sᵢ`. Hence
//! `H⁻¹ ≤ S⁻¹`. And `pᵀS⁻¹p = sup_y (2 yᵀp − yᵀSy)` is convex in `(p, S)`, which is affine in `x`: the
//! maximum is at a vertex. ∎
//!
//! For a cube of side `a` and its centre, `R² = D a²/4`.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

/// Returns `H` at a point or on a box; the entries above the diagonal define it.
pub(crate) fn gram<const D: usize>(
    formula: &Formula<D>,
    x: &SVector<Interval, D>,
) -> SMatrix<Interval, D, D> {
    symmetric(&formula.gram(x))
}

fn symmetric<S: Scalar, const D: usize>(h: &SMatrix<S, D, D>) -> SMatrix<S, D, D> {
    SMatrix::from_fn(|i, j| h[(i.min(j), i.max(j))])
}

/// Returns an `M ≥ 0` with `uᵀD²H[e,e]u ≤ M` for all points of a box and all unit vectors `e`, `u`;
/// NaN if `H` is not proved to be twice differentiable there.
///
/// The form is that of the symmetric `D² × D²` matrix `∂ₖ∂ₗHᵢⱼ` (rows `ik`, columns `jl`) at `u ⊗ e`.
/// Its largest eigenvalue is at most its Frobenius norm, and at most the largest sum of a diagonal
/// entry and the magnitudes of the others in its row.
pub(crate) fn largest_curvature<const D: usize>(
    formula: &Formula<D>,
    cube: &SVector<Interval, D>,
) -> f64 {
    let coordinates: [Interval; D] = std::array::from_fn(|i| cube[i]);
    let h = symmetric(&formula.gram(&SVector::from(Jet2::variables(&coordinates))));
    let (mut squares, mut largest_row) = (Interval::point(0.0), 0.0_f64);
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
        largest_row = largest_row.max(row.hi());
    }
    largest_row.min(squares.sqrt().hi())
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
