//! What a metric does, measured from its formula alone: `H`, its derivatives, their norms.

use nalgebra::{DMatrix, SMatrix, SVector};
use proptest::test_runner::TestRunner;
use tautline_metrics::{Jet1, Jet2, Metric};

/// Random cases that are the same in every run, unless the environment asks for others.
pub(crate) fn runner(seed: u64) -> TestRunner {
    TestRunner::new(tautline_chance::config(seed, 256))
}

/// The least and the greatest eigenvalue.
pub(crate) fn extremes<const D: usize>(h: &SMatrix<f64, D, D>) -> (f64, f64) {
    let eigenvalues = DMatrix::from_fn(D, D, |i, j| h[(i, j)]).symmetric_eigenvalues();
    (eigenvalues.min(), eigenvalues.max())
}

/// The operator norm of a symmetric matrix.
pub(crate) fn norm<const D: usize>(h: &SMatrix<f64, D, D>) -> f64 {
    let (low, high) = extremes(h);
    low.abs().max(high.abs())
}

/// `DH(x)[w]`, from the first jet along `t ↦ x + t w`.
pub(crate) fn first<const D: usize>(
    g: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet1::variables(&[0.0]);
    g.gram(&SVector::from_fn(|i, _| t * w[i] + x[i])).map(|entry: Jet1<f64, 1>| entry.first(0))
}

/// `D²H(x)[w, w]`, from the second jet along `t ↦ x + t w`.
pub(crate) fn second<const D: usize>(
    g: &impl Metric<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let [t] = Jet2::variables(&[0.0]);
    g.gram(&SVector::from_fn(|i, _| t * w[i] + x[i])).map(|entry: Jet2<f64, 1>| entry.second(0, 0))
}
