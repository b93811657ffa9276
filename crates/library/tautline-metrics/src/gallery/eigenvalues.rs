//! Bounds on the eigenvalues of a symmetric matrix.

use nalgebra::{DMatrix, SMatrix};

/// Returns bounds on the eigenvalues of the symmetric `a`, with a margin of `16 D` ulps of its
/// norm.
///
/// The error of the reduction to tridiagonal form and that of the subsequent iteration are small
/// multiples of `D` ulps of the norm. The margin exceeds their sum, so constants derived from
/// eigenvalues are bounds despite rounding.
pub(super) fn eigenvalue_bounds<const D: usize>(a: &SMatrix<f64, D, D>) -> (f64, f64) {
    let eigenvalues = DMatrix::from_fn(D, D, |i, j| a[(i, j)]).symmetric_eigenvalues();
    let (low, high) = (eigenvalues.min(), eigenvalues.max());
    let margin = 16.0 * D as f64 * f64::EPSILON * low.abs().max(high.abs());
    (low - margin, high + margin)
}
