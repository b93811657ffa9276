//! Metrics for unit tests.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

/// Returns the metric with this text.
pub(crate) fn parsed<const D: usize>(text: &str) -> Formula<D> {
    Formula::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// A ridge of height 100 that intervals never see: they are never equal to one half, so they follow
/// the other branch.
pub(crate) struct Branch;

impl Metric<1> for Branch {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let ridge = x[0] == S::constant(0.5);
        SMatrix::from_element(if ridge { S::constant(100.0) } else { S::one() })
    }
}
