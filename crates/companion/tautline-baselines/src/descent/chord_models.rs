//! The energies of single chords, to second order.

use tautline::{Batches, ChordBatch, ChordModel, Kind, Node, PointSequence};

/// Returns the models of all chords, whose energies add up to the discrete energy; `None` if there is
/// no metric at a node.
pub(crate) fn chord_models<const D: usize>(
    metric: &dyn Batches<D>,
    nodes: &'static [Node],
    sequence: &PointSequence<D>,
) -> Option<Vec<ChordModel<D>>> {
    let n = sequence.n().get();
    let mut batch = ChordBatch::new(metric, Kind::Contraction, nodes, n as f64, n);
    let mut models = Vec::with_capacity(n);
    for begin in (0..n).step_by(batch.capacity()) {
        let chords = begin..n.min(begin + batch.capacity());
        batch.evaluate(&sequence.coordinates()[chords.start * D..(chords.end + 1) * D]);
        let some = batch.singles().first(chords.len());
        models.extend((0..chords.len()).map(|lane| some.model(lane)));
    }
    batch.is_metric.then_some(models)
}
