//! `Flattened`: a metric whose heights are lowered.

use nalgebra::{SMatrix, SVector};
use tautline::{Metric, Scalar};

/// `H_s(x) = (1 − s) c I + s H(x)`: the Euclidean metric at `s = 0`, and `H` at `s = 1`. Where `H ≥ c I`,
/// it grows with `s`: bumps rise, and minimal geodesics split into those on either side of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flattened<'m, M> {
    /// The metric `H`.
    pub metric: &'m M,
    /// The level `c`, in `m²/ℓ²`.
    pub level: f64,
    /// The share `s` of `H`, from 0 to 1.
    pub share: f64,
}

impl<M: Metric<D>, const D: usize> Metric<D> for Flattened<'_, M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let flat = S::constant((1.0 - self.share) * self.level);
        self.metric.gram(x).map(|h| h * self.share) + SMatrix::from_diagonal_element(flat)
    }
}
