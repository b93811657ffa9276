//! A metric with three coordinates coupled by the cosines of their differences.

use nalgebra::{SMatrix, SVector, matrix};
use tautline_scalar::Scalar;

use super::eigenvalues::eigenvalue_bounds;
use crate::{Bounded, Constants, Metric};

/// `Hᵢⱼ = diag(1, 3/2, 2)ᵢⱼ + (2/5) cos(xᵢ − xⱼ) / (1 + |i − j|)`, `i, j = 1, 2, 3`: a full matrix
/// that is neither flat nor conformal and is constant along `(1, 1, 1)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CoupledCosines;

impl Metric<3> for CoupledCosines {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let (a, b, c) = (S::constant(1.4), S::constant(1.9), S::constant(2.4));
        let p = (x[0] - x[1]).cos() * 0.2;
        let q = (x[1] - x[2]).cos() * 0.2;
        let r = (x[0] - x[2]).cos() * (0.4 / 3.0);
        matrix![a, p, r; p, b, q; r, q, c]
    }
}

impl Bounded<3> for CoupledCosines {
    /// `c₁ = 1.326…` and `c₂ = 2.504…` are the extreme eigenvalues of `H(0)`; `L_H = √3/5` is
    /// attained; `M_H = 3/5` is an upper bound.
    fn constants(&self) -> Constants {
        // For real u put zⱼ = e^{−ixⱼ} uⱼ. Then uᵀ H(x) u = z* H(0) z, and |z| = |u|. As u and x
        // vary, z is any vector of C³. Hence the eigenvalues of H(x) lie between the extreme ones
        // of H(0).
        //
        // With W = diag(w), moving x along w differentiates z* H(0) z to z* i[W, H(0)] z. The
        // matrix has the entries i cⱼₖ (wⱼ − wₖ), where c₁₂ = c₂₃ = 1/5 and c₁₃ = 2/15. It is i
        // times the matrix of a cross product, and its norm is √(Σ cⱼₖ² (wⱼ − wₖ)²), summed over
        // j < k. The form under the root is a Laplacian with the eigenvalues 3/25 (for (1, −2, 1)),
        // 17/225 (for (1, 0, −1)) and 0.
        //
        // The entries of D²H[w, w] are at most cⱼₖ (wⱼ − wₖ)² in size, and its norm is at most its
        // largest row sum. The row sums are again Laplacian forms, each of a star: with the weights
        // 1/5, 1/5 for row 2 (greatest eigenvalue 3/5) and 1/5, 2/15 for the other rows
        // ((5 + √7)/15 < 3/5).
        let (low, high) = eigenvalue_bounds(&self.gram(&SVector::zeros()));
        Constants::new(low, high, 0.12_f64.sqrt())
            .and_then(|constants| constants.with_m_h(0.6))
            .expect("in order and positive")
    }
}
