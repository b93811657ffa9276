//! The inverse of a small symmetric positive definite block.

use nalgebra::SMatrix;

/// Returns the inverse of `A`, reading its entries `i ≤ j`; `None` if it is not positive definite
/// (or not finite).
///
/// By `A = L D Lᵀ`: that has no roots in it, and the chain of operations from one block to the next
/// is what an elimination waits for. The blocks here are `2N H` and a correction, so their condition
/// is that of the metric, and multiplying by the inverse loses no more than solving does.
#[inline(always)]
pub(crate) fn inverse<const D: usize>(a: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    // L below the diagonal, D L⁻ᵀ above it.
    let mut l = SMatrix::<f64, D, D>::zeros();
    let mut reciprocal = [0.0; D];
    for j in 0..D {
        let mut pivot = a[(j, j)];
        for k in 0..j {
            pivot -= l[(j, k)] * l[(k, j)];
        }
        // NaN and +∞ fail here too.
        if !(pivot > 0.0 && pivot < f64::INFINITY) {
            return None;
        }
        reciprocal[j] = 1.0 / pivot;
        for i in j + 1..D {
            let mut entry = a[(j, i)];
            for k in 0..j {
                entry -= l[(j, k)] * l[(k, i)];
            }
            l[(j, i)] = entry;
            l[(i, j)] = entry * reciprocal[j];
        }
    }
    // M = L⁻¹, and A⁻¹ = Mᵀ D⁻¹ M.
    let mut m = SMatrix::<f64, D, D>::identity();
    for j in 0..D {
        for i in j + 1..D {
            let mut entry = 0.0;
            for k in j..i {
                entry -= l[(i, k)] * m[(k, j)];
            }
            m[(i, j)] = entry;
        }
    }
    let mut inverse = SMatrix::<f64, D, D>::zeros();
    for j in 0..D {
        for i in 0..=j {
            let mut entry = m[(j, i)] * reciprocal[j];
            for k in j + 1..D {
                entry += m[(k, i)] * reciprocal[k] * m[(k, j)];
            }
            inverse[(i, j)] = entry;
            inverse[(j, i)] = entry;
        }
    }
    Some(inverse)
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, matrix};

    use super::inverse;

    #[test]
    fn the_product_with_the_inverse_is_the_identity() {
        let a = matrix![4.0, 2.0, -1.0; 2.0, 5.0, 0.5; -1.0, 0.5, 3.0];
        let found = inverse(&a).expect("diagonally dominant");
        // Entries of size 5 and 1: some 1e-15.
        assert!((found * a - SMatrix::identity()).amax() < 1e-14);
        assert_eq!(found, found.transpose());
        assert!(inverse(&matrix![1.0, 2.0; 2.0, 1.0]).is_none());
        assert!(inverse(&matrix![1.0, f64::NAN; f64::NAN, 1.0]).is_none());
        assert!(inverse(&matrix![f64::INFINITY]).is_none());
    }

    /// Only the upper half is read.
    #[test]
    fn the_lower_half_does_not_matter() {
        let a = matrix![4.0, 2.0; 2.0, 5.0];
        let half = matrix![4.0, 2.0; f64::NAN, 5.0];
        assert_eq!(inverse(&a), inverse(&half));
    }
}
