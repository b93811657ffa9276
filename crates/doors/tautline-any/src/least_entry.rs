//! The least value of the first entry of a metric along a curve.

use tautline::{ANY, AnyBatches, Batch, Interpolation, Kind, MetricError, PointSequence};

/// A value, and the point where it is.
pub type Least = (f64, Vec<f64>);

/// Returns the least value of the first entry of `H = f I` at the points of a sequence and in the middles of
/// its chords, and where it is. If it is not negative, the result is a negative value on a chord, if there is
/// one where a quadrature would [look](Interpolation::check).
#[must_use]
pub fn least_entry(metric: &dyn AnyBatches, sequence: &PointSequence<ANY>) -> Option<Least> {
    let n = sequence.n().get();
    let middle = |k: usize| {
        let ends = sequence.row(k).iter().zip(sequence.row(k + 1));
        ends.map(|(x, y)| x + (y - x) * 0.5)
    };
    let middles = (0..n).flat_map(middle);
    let points: Vec<f64> = sequence.coordinates().iter().copied().chain(middles).collect();
    let least = least_at(metric, &points);
    if least.as_ref().is_some_and(|(value, _)| *value < 0.0) {
        return least;
    }
    match Interpolation::new(sequence).check_by_batches(metric) {
        Err(MetricError::NotPositiveDefinite { point, eigenvalue }) if eigenvalue < 0.0 => {
            Some((eigenvalue, point))
        }
        _ => least,
    }
}

/// Returns the least value of the first entry of `H` at points whose coordinates follow one another, and
/// where it is.
#[must_use]
pub fn least_at(metric: &dyn AnyBatches, points: &[f64]) -> Option<Least> {
    let d = metric.dimension();
    let count = points.len() / d;
    let mut batch = Batch::new(metric, Kind::Square, 1, count);
    let mut least: Option<(f64, &[f64])> = None;
    for points in points.chunks(batch.lanes() * d) {
        let count = points.len() / d;
        for i in 0..d {
            let [place, vector] = batch.input(i);
            for (place, x) in place.iter_mut().zip(points[i..].iter().step_by(d)) {
                *place = *x;
            }
            // The first unit vector e has eᵀ H e = H₁₁.
            vector[..count].fill(if i == 0 { 1.0 } else { 0.0 });
        }
        // The result is whether H is a metric, which its sign says too.
        let _ = batch.evaluate(count);
        let values = batch.row(batch.layout().square[0]);
        let values = values.iter().copied().zip(points.chunks_exact(d));
        least = least.into_iter().chain(values).min_by(|(a, _), (b, _)| a.total_cmp(b));
    }
    least.map(|(value, x)| (value, x.to_vec()))
}
