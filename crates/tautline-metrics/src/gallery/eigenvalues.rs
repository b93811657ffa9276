//! Bounds on the eigenvalues of a symmetric matrix.

use nalgebra::{DMatrix, SMatrix};

/// Returns bounds on the eigenvalues of the symmetric `a`, with a margin of `16 D` ulp of its norm.
///
/// The reduction to tridiagonal form and the iteration after it each err by a small multiple of `D`
/// ulp of the norm. The margin exceeds both, so that constants derived from eigenvalues are bounds
/// despite rounding.
pub(super) fn eigenvalue_bounds<const D: usize>(a: &SMatrix<f64, D, D>) -> (f64, f64) {
    let eigenvalues = DMatrix::from_fn(D, D, |i, j| a[(i, j)]).symmetric_eigenvalues();
    let (low, high) = (eigenvalues.min(), eigenvalues.max());
    let margin = 16.0 * D as f64 * f64::EPSILON * low.abs().max(high.abs());
    (low - margin, high + margin)
}
