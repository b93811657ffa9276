//! Bounds of the eigenvalues of a symmetric matrix.

use nalgebra::{DMatrix, SMatrix};

/// Returns numbers below and above all eigenvalues of the symmetric `a`, by `16 D` ulp of its
/// norm.
///
/// The reduction to tridiagonal form and the iteration after it each make an error of a small
/// multiple of `D` ulp of the norm; `16 D` is above what either makes, so that constants which
/// come out of eigenvalues are bounds in spite of rounding.
pub(super) fn eigenvalue_bounds<const D: usize>(a: &SMatrix<f64, D, D>) -> (f64, f64) {
    let eigenvalues = DMatrix::from_fn(D, D, |i, j| a[(i, j)]).symmetric_eigenvalues();
    let (low, high) = (eigenvalues.min(), eigenvalues.max());
    let overestimation = 16.0 * D as f64 * f64::EPSILON * low.abs().max(high.abs());
    (low - overestimation, high + overestimation)
}
