//! A discrete energy to first order: value and gradient.

use nalgebra::SVector;
use tautline_metrics::{Metric, is_gram};

use crate::{PointSequence, Rule, compensated_sum::CompensatedSum, contraction::momentum};

/// The discrete energy of a point sequence with its first derivatives by the `N + 1` points.
///
/// Cheaper than a [`QuadraticModel`](crate::QuadraticModel), same formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearModel<const D: usize> {
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// Its gradient by each of the `N + 1` points, in `m²/ℓ`.
    pub gradient: Vec<SVector<f64, D>>,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node.
    pub is_metric: bool,
}

impl<const D: usize> LinearModel<D> {
    /// Expands the discrete energy of `rule` about `sequence`. NaN where the metric is.
    #[must_use]
    pub fn new<R: Rule>(_rule: R, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Self {
        let mut gradient = Vec::with_capacity(sequence.points().len());
        let n = sequence.n().get() as f64;
        let mut energy = CompensatedSum::default();
        let mut is_metric = true;
        let mut carried = SVector::<f64, D>::zeros();
        for (x, d) in sequence.chords() {
            let mut near = carried;
            carried = SVector::zeros();
            for node in R::NODES {
                let w = node.weight * n;
                let (h, g) = momentum(metric, &(x + d * node.fraction), &d);
                is_metric &= is_gram(&h);
                let hd = h * d;
                energy.add(w * d.dot(&hd));
                near += (g * (1.0 - node.fraction) - hd * 2.0) * w;
                carried += (g * node.fraction + hd * 2.0) * w;
            }
            gradient.push(near);
        }
        gradient.push(carried);
        Self { energy: energy.value(), gradient, is_metric }
    }
}

/// Returns the discrete energy, in `m²`, and its gradient by each point, in `m²/ℓ`: the numbers of
/// [`LinearModel`].
#[must_use]
pub fn energy_gradient<R: Rule, const D: usize>(
    rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> (f64, Vec<SVector<f64, D>>) {
    let LinearModel { energy, gradient, .. } = LinearModel::new(rule, metric, sequence);
    (energy, gradient)
}
