//! Programs with a mistake: discrete energy, gradient and Christoffel symbols.

use nalgebra::{SMatrix, SVector};
use tautline::{Jet1, Metric, MetricError, PointSequence, Rule, check_gram};

use super::Mutant;

/// Returns the rule that a mutant takes for this one.
pub(crate) fn mistaken_rule(mutant: Mutant, rule: Rule) -> Rule {
    match (mutant, rule == Rule::TRAPEZOIDAL) {
        (Mutant::RulesExchanged, true) => Rule::LEFT_ENDPOINT,
        (Mutant::RulesExchanged, false) => Rule::TRAPEZOIDAL,
        (Mutant::TrueTrapezoid, true) => Rule::TRUE_TRAPEZOID,
        _ => rule,
    }
}

/// Returns the discrete energy without the last chord.
pub(crate) fn without_last_chord<const D: usize>(
    rule: Rule,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    let mut points = sequence.points().to_vec();
    let last = points.len() - 1;
    // A chord of length 0 adds no energy, and N remains the same.
    points[last] = points[last - 1];
    rule.energy(metric, &PointSequence::new(points).expect("finite points"))
}

/// Returns the gradient of the discrete energy as if `H` did not depend on the point.
pub(crate) fn frozen_gradient<const D: usize>(
    rule: Rule,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> Vec<SVector<f64, D>> {
    let n = sequence.n().get() as f64;
    let mut gradient = vec![SVector::zeros(); sequence.points().len()];
    for (k, (x, chord)) in sequence.chords().enumerate() {
        for node in rule.nodes() {
            let gram: SMatrix<f64, D, D> = metric.gram(&(x + chord * node.fraction));
            let force = gram * chord * (2.0 * n * node.weight);
            gradient[k] -= force;
            gradient[k + 1] += force;
        }
    }
    gradient
}

/// Returns `Γᵏᵢⱼ = ½ Σ H⁻¹ₖₗ (∂ᵢHₗⱼ + ∂ⱼHₗᵢ + ∂ₗHᵢⱼ)`, where the last term wrongly has a plus.
pub(crate) fn christoffel_with_wrong_sign<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
    let gram = check_gram(metric, x)?;
    let inverse = gram.cholesky().map_or_else(SMatrix::zeros, |factor| factor.inverse());
    let jets = metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
    let d = |k: usize, i: usize, j: usize| jets[(i.min(j), i.max(j))].first(k);
    let mut gamma = [SMatrix::zeros(); D];
    for (k, symbols) in gamma.iter_mut().enumerate() {
        *symbols = SMatrix::from_fn(|i, j| {
            let term = |l: usize| inverse[(k, l)] * (d(i, l, j) + d(j, l, i) + d(l, i, j));
            0.5 * (0..D).map(term).sum::<f64>()
        });
    }
    Ok(gamma)
}
