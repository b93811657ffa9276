//! A discrete energy to second order: value, gradient and block-tridiagonal Hessian.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{
    BlockTridiagonal, PointSequence, Rule,
    compensated_sum::CompensatedSum,
    contraction::{Contraction, momentum},
};

/// The discrete energy of a point sequence with its first and second derivatives by the
/// `N + 1` points.
///
/// Derivation, for one node of weight 1 at the fraction `θ` of the chord `d = y − x`, with
/// `H` and its derivatives at `x + θ d`, and `e = N dᵀHd` its part of the energy:
///
/// ```text
/// q = H d,   Gₖ = dᵀ ∂ₖH d,   Pᵢₖ = (∂ₖH d)ᵢ,   Qₖₗ = dᵀ ∂ₖ∂ₗH d
/// ∂e/∂x = N (−2q + (1−θ) G),                  ∂e/∂y = N (2q + θ G)
/// ∂²e/∂x² = N (2H − 2(1−θ)(P + Pᵀ) + (1−θ)² Q),  ∂²e/∂y² = N (2H + 2θ(P + Pᵀ) + θ² Q)
/// ∂²e/∂x∂y = N (−2H − 2θ P + 2(1−θ) Pᵀ + θ(1−θ) Q)
/// ```
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
    pub fn new<R: Rule>(_rule: R, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Self {
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
            let (mut g_near, mut h_near) = carried;
            carried = (SVector::zeros(), SMatrix::zeros());
            let mut coupling = SMatrix::<f64, D, D>::zeros();
            for node in R::NODES {
                let (w, near, far) = (node.weight * factor, 1.0 - node.fraction, node.fraction);
                let Contraction { h, g, p, q } = Contraction::new(metric, &(x + d * far), &d);
                let hd = h * d;
                energy.add(w * d.dot(&hd));
                trace += w * h.trace();
                g_near += (g * near - hd * 2.0) * w;
                carried.0 += (g * far + hd * 2.0) * w;
                let symmetric = p + p.transpose();
                h_near += (h * 2.0 - symmetric * (2.0 * near) + q * (near * near)) * w;
                carried.1 += (h * 2.0 + symmetric * (2.0 * far) + q * (far * far)) * w;
                coupling += (q * (near * far) - h * 2.0 - p * (2.0 * far)
                    + p.transpose() * (2.0 * near))
                    * w;
            }
            gradient.push(g_near);
            diagonal.push(h_near);
            upper.push(coupling);
        }
        gradient.push(carried.0);
        diagonal.push(carried.1);
        let hessian = BlockTridiagonal { diagonal, upper };
        let mean_gram = trace / (factor * factor * D as f64);
        Self { energy: energy.value(), gradient, hessian, mean_gram }
    }
}

/// Returns the discrete energy, in `m²`, and its gradient by each point, in `m²/ℓ`.
///
/// First derivatives only: cheaper than [`QuadraticModel`], same formulas.
#[must_use]
pub fn energy_gradient<R: Rule, const D: usize>(
    _rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> (f64, Vec<SVector<f64, D>>) {
    let n = sequence.n().get();
    let factor = n as f64;
    let mut energy = CompensatedSum::default();
    let mut gradient = vec![SVector::zeros(); n + 1];
    for (k, (x, d)) in sequence.chords().enumerate() {
        for node in R::NODES {
            let w = node.weight * factor;
            let y = x + d * node.fraction;
            let (hd, g) = momentum(metric, &y, &d);
            energy.add(w * d.dot(&hd));
            gradient[k] += (g * (1.0 - node.fraction) - hd * 2.0) * w;
            gradient[k + 1] += (g * node.fraction + hd * 2.0) * w;
        }
    }
    (energy.value(), gradient)
}
