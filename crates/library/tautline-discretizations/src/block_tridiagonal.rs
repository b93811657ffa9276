//! `BlockTridiagonal`: a symmetric matrix of `D × D` blocks that couples only neighbours.

use nalgebra::{SMatrix, SVector};

/// A symmetric block-tridiagonal matrix with `N + 1` blocks of `D` rows.
///
/// Block `(n, n)` is `diagonal[n]`, block `(n, n + 1)` is `upper[n]`, and block `(n + 1, n)` is the
/// transpose of `upper[n]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockTridiagonal<const D: usize> {
    /// The `N + 1` symmetric diagonal blocks.
    pub diagonal: Vec<SMatrix<f64, D, D>>,
    /// The `N` blocks above the diagonal.
    pub upper: Vec<SMatrix<f64, D, D>>,
}

impl<const D: usize> BlockTridiagonal<D> {
    /// Returns the zero matrix with `n + 1` diagonal blocks.
    #[must_use]
    pub fn zeros(n: usize) -> Self {
        Self { diagonal: vec![SMatrix::zeros(); n + 1], upper: vec![SMatrix::zeros(); n] }
    }

    /// Returns the product with a vector of `N + 1` blocks.
    #[must_use]
    pub fn mul(&self, v: &[SVector<f64, D>]) -> Vec<SVector<f64, D>> {
        let mut product: Vec<_> = self.diagonal.iter().zip(v).map(|(a, v)| a * v).collect();
        for (n, block) in self.upper.iter().enumerate() {
            product[n] += block * v[n + 1];
            product[n + 1] += block.transpose() * v[n];
        }
        product
    }
}
