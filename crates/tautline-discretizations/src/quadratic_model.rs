//! A discrete energy to second order: value, gradient and block-tridiagonal Hessian.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{BlockTridiagonal, ChordModel, PointSequence, Rule, compensated_sum::CompensatedSum};

/// The discrete energy of a point sequence with its first and second derivatives by the
/// `N + 1` points: the sum of the [`ChordModel`]s.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuadraticModel<const D: usize> {
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// Its gradient by each of the `N + 1` points, in `m²/ℓ`.
    pub gradient: Vec<SVector<f64, D>>,
    /// Its second derivatives, in `m²/ℓ²`.
    pub hessian: BlockTridiagonal<D>,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`: the size of the metric.
    pub mean_gram: f64,
}

impl<const D: usize> QuadraticModel<D> {
    /// Expands the discrete energy of `rule` about `sequence`. NaN where the metric is.
    #[must_use]
    pub fn new<R: Rule>(rule: R, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Self {
        let n = sequence.n().get();
        let factor = n as f64;
        let mut energy = CompensatedSum::default();
        let mut trace = 0.0;
        let mut gradient = Vec::with_capacity(n + 1);
        let mut diagonal = Vec::with_capacity(n + 1);
        let mut upper = Vec::with_capacity(n);
        // What the chord before has left for the point between.
        let mut carried = (SVector::<f64, D>::zeros(), SMatrix::<f64, D, D>::zeros());
        for (x, d) in sequence.chords() {
            let chord = ChordModel::new(rule, metric, x, &d, factor);
            energy.add(chord.energy);
            trace += chord.trace;
            gradient.push(carried.0 + chord.gradient[0]);
            diagonal.push(carried.1 + chord.hessian[0]);
            upper.push(chord.coupling);
            carried = (chord.gradient[1], chord.hessian[1]);
        }
        gradient.push(carried.0);
        diagonal.push(carried.1);
        let hessian = BlockTridiagonal { diagonal, upper };
        let mean_gram = trace / (factor * factor * D as f64);
        Self { energy: energy.value(), gradient, hessian, mean_gram }
    }
}
