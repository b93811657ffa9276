//! The discrete energy of a trial, or `None` where the metric is not positive.

use tautline_formula::{AnyBatches, Kind};

use crate::{ChordBatch, CompensatedSum, Node};

/// Returns the discrete energy of the rule with these `nodes`, in `m²`, for points whose coordinates
/// follow one another. The result is `None` if the
/// energy is not finite, or if the term of a node is negative: that node then lies outside the
/// region where the metric is positive definite.
///
/// # Panics
///
/// If there is no point.
#[must_use]
pub fn admissible_energy(
    nodes: &'static [Node],
    metric: &dyn AnyBatches,
    points: &[f64],
) -> Option<f64> {
    let dimension = metric.dimension();
    let n = points.len() / dimension - 1;
    let (mut energy, mut is_admissible) = (CompensatedSum::default(), true);
    let mut batch = ChordBatch::new(metric, Kind::Square, nodes, 1.0, n);
    for begin in (0..n).step_by(batch.capacity()) {
        let end = n.min(begin + batch.capacity());
        batch.evaluate(&points[begin * dimension..(end + 1) * dimension]);
        batch.energies().for_first(end - begin, |square| {
            // A NaN fails this comparison.
            is_admissible &= square >= 0.0;
            energy.add(square);
        });
        if !is_admissible {
            return None;
        }
    }
    let energy = energy.value() * n as f64;
    energy.is_finite().then_some(energy)
}
