//! The discrete energy of a trial, or `None` where the metric is not positive.

use nalgebra::SVector;
use tautline_formula::{Batches, Kind};

use crate::{ChordBatch, CompensatedSum, Node, point_sequence::chords as chords_of};

/// Returns the discrete energy of the rule with these `nodes`, in `m²`. The result is `None` if the
/// energy is not finite, or if the term of a node is negative: that node then lies outside the
/// region where the metric is positive definite.
///
/// # Panics
///
/// If there is no point.
#[must_use]
pub fn admissible_energy<const D: usize>(
    nodes: &'static [Node],
    metric: &dyn Batches<D>,
    points: &[SVector<f64, D>],
) -> Option<f64> {
    let n = points.len() - 1;
    let (mut energy, mut is_admissible) = (CompensatedSum::default(), true);
    let mut batch = ChordBatch::new(metric, Kind::Square, nodes, 1.0, n);
    for begin in (0..n).step_by(batch.capacity()) {
        let chords = begin..n.min(begin + batch.capacity());
        batch.evaluate_from(0, chords_of(&points[chords.start..=chords.end]));
        batch.energies().for_first(chords.len(), |square| {
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
