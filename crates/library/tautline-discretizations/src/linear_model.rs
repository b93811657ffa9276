//! `LinearModel`: a discrete energy to first order, with its value and gradient.

use nalgebra::SVector;
use tautline_formula::{AnyBatches, Kind, Plain};
use tautline_metrics::Metric;

use crate::{ChordBatch, Node, PointSequence, Rule, compensated_sum::CompensatedSum};

/// The discrete energy of a point sequence, with its first derivatives with respect to the `N + 1`
/// points.
///
/// The formulas are those of a [`QuadraticModel`](crate::QuadraticModel), at a lower cost.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearModel {
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The derivatives of the energy with respect to the coordinates of the `N + 1` points, point by
    /// point, in `m²/ℓ`.
    pub slopes: Vec<f64>,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node.
    pub is_metric: bool,
}

impl LinearModel {
    /// Expands the discrete energy of `rule` about `sequence`. The result is NaN if the metric is
    /// NaN.
    #[must_use]
    pub fn new<const D: usize>(
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Self {
        Self::by_batches(rule.nodes(), &Plain::new(metric), sequence)
    }

    /// Expands like [`new`](Self::new), for a metric that is evaluated in batches.
    #[must_use]
    pub fn by_batches<const D: usize>(
        nodes: &'static [Node],
        metric: &dyn AnyBatches,
        sequence: &PointSequence<D>,
    ) -> Self {
        Self::at(nodes, metric, sequence.coordinates())
    }

    /// Returns the gradients of the energy with respect to each of the `N + 1` points of `R^D`, in
    /// `m²/ℓ`.
    #[must_use]
    pub fn gradient<const D: usize>(&self) -> &[SVector<f64, D>] {
        bytemuck::cast_slice(&self.slopes)
    }

    /// Returns the same gradients, for writing.
    #[must_use]
    pub fn gradient_mut<const D: usize>(&mut self) -> &mut [SVector<f64, D>] {
        bytemuck::cast_slice_mut(&mut self.slopes)
    }

    /// Returns the model with these gradients.
    #[must_use]
    pub fn with_gradient<const D: usize>(energy: f64, gradient: Vec<SVector<f64, D>>) -> Self {
        Self { energy, slopes: bytemuck::cast_vec(gradient), is_metric: true }
    }

    /// Expands about points whose coordinates follow one another.
    fn at(nodes: &'static [Node], metric: &dyn AnyBatches, points: &[f64]) -> Self {
        let dimension = metric.dimension();
        let n = points.len() / dimension - 1;
        let mut slopes = vec![0.0; points.len()];
        let mut carried = vec![0.0; dimension];
        let mut energy = CompensatedSum::default();
        let mut batch = ChordBatch::new(metric, Kind::Momentum, nodes, n as f64, n);
        for begin in (0..n).step_by(batch.capacity()) {
            let end = n.min(begin + batch.capacity());
            batch.evaluate(&points[begin * dimension..(end + 1) * dimension]);
            batch.energies().for_first(end - begin, |term| energy.add(term));
            for (i, carried) in carried.iter_mut().enumerate() {
                let mut place = begin * dimension + i;
                *carried = batch.momenta(i).for_first(end - begin, *carried, |slope| {
                    slopes[place] = slope;
                    place += dimension;
                });
            }
        }
        slopes[n * dimension..].copy_from_slice(&carried);
        Self { energy: energy.value(), slopes, is_metric: batch.is_metric }
    }
}

/// Returns the energy and the gradient of a [`LinearModel`].
#[must_use]
pub fn energy_gradient<const D: usize>(
    rule: Rule,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> (f64, Vec<SVector<f64, D>>) {
    let LinearModel { energy, slopes, .. } = LinearModel::new(rule, metric, sequence);
    (energy, bytemuck::cast_vec(slopes))
}
