//! The signs of costs and speeds, which the metric, made of their squares, does not show.

use tautline::{Batch, Batches, Kind, PointSequence, Prepared, SVector};

use crate::{
    Diagnostic, Question,
    file::{expression::Text, metric::MetricFile},
    formula::formula_of,
};

impl Question {
    /// Refuses a cost or a speed that is negative at a point of a curve or in the middle of a
    /// chord.
    pub(crate) fn check_sign<const D: usize>(
        &self,
        sequence: &PointSequence<D>,
    ) -> Result<(), Diagnostic> {
        let squared = squared(self.problem.metric.get_ref());
        squared.into_iter().try_for_each(|(name, text)| self.check_positive(name, text, sequence))
    }

    fn check_positive<const D: usize>(
        &self,
        name: &str,
        text: &Text,
        sequence: &PointSequence<D>,
    ) -> Result<(), Diagnostic> {
        // The entries of φ I are the function itself.
        let phi = MetricFile::Phi(text.clone());
        let phi = formula_of::<D>(&phi, &self.problem, &self.numbers(), &self.tables, None)?;
        let least = least_entry(&Prepared::new(&phi), sequence);
        let Some((x, value)) = least.filter(|(_, value)| *value < 0.0) else { return Ok(()) };
        let message = format!("the {name} is {value} at {:?}", x.as_slice());
        Err(Diagnostic::new(message, text.span()).label("expected a positive function"))
    }
}

/// Returns the least value of the first entry of `H` at the points of a sequence and in the middles of
/// its chords, and where it is.
pub(crate) fn least_entry<const D: usize>(
    metric: &dyn Batches<D>,
    sequence: &PointSequence<D>,
) -> Option<(SVector<f64, D>, f64)> {
    let middles = sequence.chords().map(|(x, d)| x + d * 0.5);
    let points: Vec<SVector<f64, D>> = sequence.points().iter().copied().chain(middles).collect();
    // The first unit vector e has eᵀ H e = H₁₁.
    let mut unit = SVector::<f64, D>::zeros();
    unit[0] = 1.0;
    let mut batch = Batch::new(metric, Kind::Square, 1, points.len());
    let mut least = None;
    for points in points.chunks(batch.lanes()) {
        let mut inputs = batch.inputs(points.len());
        points.iter().enumerate().for_each(|(lane, x)| inputs.set(lane, x, &unit));
        // The result is whether H is a metric, which its sign says too.
        let _ = batch.evaluate(points.len());
        let values = batch.row(batch.layout().square[0]);
        let values = points.iter().copied().zip(values.iter().copied());
        least = least.into_iter().chain(values).min_by(|(_, a), (_, b)| a.total_cmp(b));
    }
    least
}

/// Returns the costs and speeds in a metric, with their names.
fn squared(metric: &MetricFile) -> Vec<(&'static str, &Text)> {
    match metric {
        MetricFile::Cost(text) => vec![("cost", text)],
        MetricFile::Speed(text) => vec![("speed", text)],
        MetricFile::Sum(metrics) => metrics.get_ref().iter().flat_map(squared).collect(),
        MetricFile::Scaled(scaled) => squared(&scaled.metric),
        MetricFile::Product(blocks) => {
            blocks.get_ref().iter().flat_map(|block| squared(&block.metric)).collect()
        }
        _ => Vec::new(),
    }
}
