//! `Ldl`: the factorisation `L D Lᵀ` of a small symmetric positive definite block.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Lanes;

/// The factorisation `A = L D Lᵀ` with ones on the diagonal of `L`. It is a Cholesky factorisation
/// without square roots, which would lengthen the chain of dependent operations from block to
/// block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ldl<const D: usize, T = f64> {
    /// `L` below the diagonal and the reciprocals of `D` on it. Entries above the diagonal are
    /// arbitrary.
    pub(crate) factors: SMatrix<T, D, D>,
}

impl<T: Lanes, const D: usize> Ldl<D, T> {
    /// Returns a placeholder, every entry of which is overwritten later.
    pub(crate) fn zero() -> Self {
        Self { factors: SMatrix::zeros() }
    }

    /// Factorises `A`, of which only the lower triangle `i ≥ j` is read. The result is `None`
    /// unless the matrix is positive definite and finite in every lane.
    #[inline(always)]
    pub(crate) fn new(a: &SMatrix<T, D, D>) -> Option<Self> {
        let mut factors = *a;
        for j in 0..D {
            let pivot = factors[(j, j)];
            // NaN and +∞ fail here too.
            if !pivot.are_positive() {
                return None;
            }
            let reciprocal = pivot.recip();
            factors[(j, j)] = reciprocal;
            for k in j + 1..D {
                let factor = factors[(k, j)] * reciprocal;
                for i in k..D {
                    let eliminated = factors[(i, j)] * factor;
                    factors[(i, k)] -= eliminated;
                }
                factors[(k, j)] = factor;
            }
        }
        Some(Self { factors })
    }

    /// Returns `W = B L⁻ᵀ` and `W D⁻¹`, so that `B A⁻¹ Bᵀ = W (W D⁻¹)ᵀ`.
    #[inline(always)]
    pub(crate) fn divide(&self, b: &SMatrix<T, D, D>) -> [SMatrix<T, D, D>; 2] {
        let mut w = *b;
        for j in 0..D {
            for k in j + 1..D {
                let factor = self.factors[(k, j)];
                for i in 0..D {
                    let eliminated = w[(i, j)] * factor;
                    w[(i, k)] -= eliminated;
                }
            }
        }
        let scaled = SMatrix::from_fn(|i, j| w[(i, j)] * self.factors[(j, j)]);
        [w, scaled]
    }

    /// Returns `y = L⁻¹ b` and `D⁻¹ y`, so that `bᵀ A⁻¹ b = y · D⁻¹ y`.
    #[inline(always)]
    pub(crate) fn forward(&self, b: SVector<T, D>) -> [SVector<T, D>; 2] {
        let mut y = b;
        for j in 0..D {
            for i in j + 1..D {
                let eliminated = self.factors[(i, j)] * y[j];
                y[i] -= eliminated;
            }
        }
        [y, SVector::from_fn(|i, _| y[i] * self.factors[(i, i)])]
    }

    /// Returns `L⁻ᵀ z`.
    #[inline(always)]
    pub(crate) fn backward(&self, z: SVector<T, D>) -> SVector<T, D> {
        let mut x = z;
        for j in (0..D).rev() {
            for i in j + 1..D {
                let known = self.factors[(i, j)] * x[i];
                x[j] -= known;
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, matrix, vector};
    use tautline_metrics::Pair;

    use super::Ldl;

    #[test]
    fn solving_and_dividing_multiply_back() {
        let a = matrix![4.0, 2.0, -1.0; 2.0, 5.0, 0.5; -1.0, 0.5, 3.0];
        let ldl = Ldl::new(&a).expect("diagonally dominant");
        let b = vector![1.0, -2.0, 0.5];
        let [y, scaled] = ldl.forward(b);
        let x = ldl.backward(scaled);
        // For entries of size 5 and 1 the errors are about 1e-15.
        assert!((a * x - b).amax() < 1e-14);
        assert!((y.dot(&scaled) - b.dot(&x)).abs() < 1e-14);
        let c = matrix![1.0, 2.0, 3.0; 0.0, -1.0, 2.0; 0.5, 0.25, 4.0];
        let [w, scaled] = ldl.divide(&c);
        let inverse = a.try_inverse().expect("regular");
        assert!((w * scaled.transpose() - c * inverse * c.transpose()).amax() < 1e-14);
        assert!(Ldl::new(&matrix![1.0, 2.0; 2.0, 1.0]).is_none());
        assert!(Ldl::new(&matrix![1.0, f64::NAN; f64::NAN, 1.0]).is_none());
        assert!(Ldl::new(&matrix![f64::INFINITY]).is_none());
    }

    #[test]
    fn both_lanes_have_to_be_positive_definite() {
        let (definite, indefinite) = (matrix![2.0, 1.0; 1.0, 2.0], matrix![1.0, 2.0; 2.0, 1.0]);
        let pair = |a: &SMatrix<f64, 2, 2>, b: &SMatrix<f64, 2, 2>| a.zip_map(b, Pair::new);
        assert!(Ldl::new(&pair(&definite, &definite)).is_some());
        assert!(Ldl::new(&pair(&definite, &indefinite)).is_none());
        assert!(Ldl::new(&pair(&indefinite, &definite)).is_none());
    }

    #[test]
    fn only_the_lower_triangle_is_read() {
        let solve = |a: &SMatrix<f64, 2, 2>| {
            let ldl = Ldl::new(a).expect("positive definite");
            ldl.backward(ldl.forward(vector![1.0, 3.0])[1])
        };
        assert_eq!(solve(&matrix![4.0, f64::NAN; 2.0, 5.0]), solve(&matrix![4.0, 2.0; 2.0, 5.0]));
    }
}
