//! `LinearModel`: a discrete energy to first order, with its value and gradient.

use nalgebra::SVector;
use tautline_formula::{Batches, Kind, Plain};
use tautline_metrics::Metric;

use crate::{ChordBatch, Node, PointSequence, Rule, compensated_sum::CompensatedSum};

/// The discrete energy of a point sequence, with its first derivatives with respect to the `N + 1`
/// points.
///
/// The formulas are those of a [`QuadraticModel`](crate::QuadraticModel), at a lower cost.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearModel<const D: usize> {
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The gradients of the energy with respect to each of the `N + 1` points, in `m²/ℓ`.
    pub gradient: Vec<SVector<f64, D>>,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node.
    pub is_metric: bool,
}

impl<const D: usize> LinearModel<D> {
    /// Expands the discrete energy of `rule` about `sequence`. The result is NaN if the metric is
    /// NaN.
    #[must_use]
    pub fn new(rule: Rule, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Self {
        Self::by_batches(rule.nodes(), &Plain::new(metric), sequence)
    }

    /// Expands like [`new`](Self::new), for a metric that is evaluated in batches.
    #[must_use]
    pub fn by_batches(
        nodes: &'static [Node],
        metric: &dyn Batches<D>,
        sequence: &PointSequence<D>,
    ) -> Self {
        let mut gradient = Vec::with_capacity(sequence.points().len());
        let n = sequence.n().get();
        let mut energy = CompensatedSum::default();
        let mut batch = ChordBatch::new(metric, Kind::Momentum, nodes, n as f64, n);
        let mut ends = [SVector::<f64, D>::zeros(); 2];
        for begin in (0..n).step_by(batch.capacity()) {
            let chords = begin..n.min(begin + batch.capacity());
            batch.evaluate_from(0, sequence.chords_in(chords.clone()));
            batch.energies().for_first(chords.len(), |term| energy.add(term));
            let momenta = batch.momenta().first(chords.len());
            for k in 0..chords.len() {
                momenta.add(k, &mut ends);
                gradient.push(ends[0]);
                ends = [ends[1], SVector::zeros()];
            }
        }
        gradient.push(ends[0]);
        Self { energy: energy.value(), gradient, is_metric: batch.is_metric }
    }
}

/// Returns the energy and the gradient of a [`LinearModel`].
#[must_use]
pub fn energy_gradient<const D: usize>(
    rule: Rule,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> (f64, Vec<SVector<f64, D>>) {
    let LinearModel { energy, gradient, .. } = LinearModel::new(rule, metric, sequence);
    (energy, gradient)
}
