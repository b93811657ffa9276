//! The inverse Cholesky factor of a small symmetric positive definite block.

use nalgebra::SMatrix;
use tautline_metrics::cholesky;

/// Returns the lower triangular `M` with `Mᵀ M = A⁻¹`, that is `M = L⁻¹` for `A = L Lᵀ`;
/// `None` if `A` is not positive definite.
///
/// Multiplying by `M` has no chain of divisions in it, which solving with `L` has. The blocks
/// here are `2N H` and a correction, so their condition is that of the metric.
pub(crate) fn inverse_factor<const D: usize>(a: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    let l = cholesky(a)?;
    let mut m = SMatrix::<f64, D, D>::zeros();
    for j in 0..D {
        m[(j, j)] = 1.0 / l[(j, j)];
        for i in j + 1..D {
            let mut entry = 0.0;
            for k in j..i {
                entry -= l[(i, k)] * m[(k, j)];
            }
            m[(i, j)] = entry / l[(i, i)];
        }
    }
    Some(m)
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, matrix};

    use super::inverse_factor;

    #[test]
    fn the_square_of_the_factor_is_the_inverse() {
        let a = matrix![4.0, 2.0, -1.0; 2.0, 5.0, 0.5; -1.0, 0.5, 3.0];
        let m = inverse_factor(&a).expect("diagonally dominant");
        // Entries of size 5 and 1: some 1e-15.
        assert!((m.transpose() * m * a - SMatrix::identity()).amax() < 1e-14);
        assert!(inverse_factor(&matrix![1.0, 2.0; 2.0, 1.0]).is_none());
    }
}
