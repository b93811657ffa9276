//! `ByGram`: a metric of which nothing is known but the formula of its Gram matrix.

use tautline::{Metric, SMatrix, SVector, Scalar};

/// A metric without formulas of its own for `uᵀHu` and `Hu`.
pub(crate) struct ByGram<M>(pub(crate) M);

impl<M: Metric<D>, const D: usize> Metric<D> for ByGram<M> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.0.gram(x)
    }
}
