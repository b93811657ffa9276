//! The square of a vector under a metric whose dimension is a value.

use tautline_formula::AnyBatches;
use tautline_metrics::square_of;

/// Returns `dᵀ H(x) d`, in `m²`.
pub(crate) fn gram_square(metric: &dyn AnyBatches, x: &[f64], d: &[f64]) -> f64 {
    let mut h = vec![0.0; x.len() * x.len()];
    metric.gram_into(x, &mut h);
    square_of(&h, d)
}
