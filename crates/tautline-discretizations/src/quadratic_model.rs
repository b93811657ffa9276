//! `QuadraticModel`: a discrete energy to second order, with its value, gradient and
//! block-tridiagonal Hessian.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Batches, Kind, Plain};
use tautline_metrics::Metric;

use crate::{
    BlockTridiagonal, ChordBatch, Node, PointSequence, Rule, compensated_sum::CompensatedSum,
};

/// The discrete energy of a point sequence, with its first and second derivatives with respect to
/// the `N + 1` points. It is the sum of the [`ChordModel`](crate::ChordModel)s of the chords.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuadraticModel<const D: usize> {
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The gradients of the energy with respect to each of the `N + 1` points, in `m²/ℓ`.
    pub gradient: Vec<SVector<f64, D>>,
    /// The second derivatives of the energy, in `m²/ℓ²`.
    pub hessian: BlockTridiagonal<D>,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`. It measures the size of the metric.
    pub mean_gram: f64,
}

impl<const D: usize> QuadraticModel<D> {
    /// Expands the discrete energy of `rule` about `sequence`. The result is NaN if the metric is
    /// NaN.
    #[must_use]
    pub fn new(rule: Rule, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Self {
        let mut model = Self::default();
        model.expand_by_batches(rule.nodes(), &Plain::new(metric), sequence);
        model
    }

    /// Expands like [`new`](Self::new), for a metric that is evaluated in batches. The result
    /// overwrites this model and uses its memory.
    pub fn expand_by_batches(
        &mut self,
        nodes: &'static [Node],
        metric: &dyn Batches<D>,
        sequence: &PointSequence<D>,
    ) {
        let n = sequence.n().get();
        let factor = n as f64;
        let (mut energy, mut trace) = (CompensatedSum::default(), 0.0);
        let Self { gradient, hessian: BlockTridiagonal { diagonal, upper }, .. } = self;
        gradient.resize(n + 1, SVector::zeros());
        diagonal.resize(n + 1, SMatrix::zeros());
        upper.resize(n, SMatrix::zeros());
        // What the previous chord contributes to the point that it shares with this one.
        let mut carried = (SVector::<f64, D>::zeros(), SMatrix::<f64, D, D>::zeros());
        let mut batch = ChordBatch::new(metric, Kind::Contraction, nodes, factor, n);
        for begin in (0..n).step_by(batch.capacity()) {
            let chords = begin..n.min(begin + batch.capacity());
            batch.evaluate_from(0, sequence.chords_in(chords.clone()));
            let models = batch.singles().first(chords.len());
            let is_midpoint = models.is_midpoint();
            for k in chords {
                let lane = k - begin;
                let chord =
                    if is_midpoint { models.model_at_midpoint(lane) } else { models.model(lane) };
                energy.add(chord.energy);
                trace += chord.trace;
                gradient[k] = carried.0 + chord.gradient[0];
                diagonal[k] = carried.1 + chord.hessian[0];
                upper[k] = chord.coupling;
                carried = (chord.gradient[1], chord.hessian[1]);
            }
        }
        (gradient[n], diagonal[n]) = carried;
        self.energy = energy.value();
        self.mean_gram = trace / (factor * factor * D as f64);
    }
}
