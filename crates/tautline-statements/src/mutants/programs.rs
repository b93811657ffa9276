//! The mistakes of the mutants in the programs that are generic in the dimension, without the solver.

use nalgebra::{SMatrix, SVector};
use tautline::{
    Constants, Integral, Interpolation, Jet1, LeftEndpoint, Metric, MetricError, PointSequence,
    Rule, Trapezoidal, TrueTrapezoid, bounds::Region, check_gram, christoffel,
    energy_gradient as gradient,
};

use super::{Mutant, with_l_h};

/// Whether `R` reads the metric as the trapezoidal rule of the paper does.
pub(super) fn is_trapezoidal<R: Rule>() -> bool {
    R::NODES == Trapezoidal::NODES
}

pub(crate) fn discrete_energy<R: Rule, const D: usize>(
    mutant: Mutant,
    rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    match mutant {
        Mutant::RulesExchanged if is_trapezoidal::<R>() => LeftEndpoint.energy(metric, sequence),
        Mutant::RulesExchanged => Trapezoidal.energy(metric, sequence),
        Mutant::TrueTrapezoid if is_trapezoidal::<R>() => TrueTrapezoid.energy(metric, sequence),
        Mutant::EnergyHalved => 0.5 * rule.energy(metric, sequence),
        Mutant::LastChordLost => without_last_chord(rule, metric, sequence),
        _ => rule.energy(metric, sequence),
    }
}

pub(crate) fn discrete_length<R: Rule, const D: usize>(
    mutant: Mutant,
    rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    match mutant {
        // Σ dᵀHd over the chords d.
        Mutant::RootLost => rule.energy(metric, sequence) / sequence.n().get() as f64,
        Mutant::RulesExchanged if is_trapezoidal::<R>() => LeftEndpoint.length(metric, sequence),
        Mutant::RulesExchanged => Trapezoidal.length(metric, sequence),
        Mutant::TrueTrapezoid if is_trapezoidal::<R>() => TrueTrapezoid.length(metric, sequence),
        _ => rule.length(metric, sequence),
    }
}

pub(crate) fn energy_gradient<R: Rule, const D: usize>(
    mutant: Mutant,
    rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> Vec<SVector<f64, D>> {
    match mutant {
        Mutant::RulesExchanged if is_trapezoidal::<R>() => {
            gradient(LeftEndpoint, metric, sequence).1
        }
        Mutant::RulesExchanged => gradient(Trapezoidal, metric, sequence).1,
        Mutant::GradientReversed => {
            gradient(rule, metric, sequence).1.into_iter().map(|slope| -slope).collect()
        }
        Mutant::MetricFrozen => frozen_gradient::<R, D>(metric, sequence),
        _ => gradient(rule, metric, sequence).1,
    }
}

pub(crate) fn curve_energy<const D: usize>(
    mutant: Mutant,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> Integral {
    let exact = |value| Integral { value, error: 0.0 };
    match mutant {
        Mutant::QuadratureOfOneNode => exact(Trapezoidal.energy(metric, sequence)),
        Mutant::QuadratureByEnds => exact(TrueTrapezoid.energy(metric, sequence)),
        _ => Interpolation::new(sequence).energy(metric),
    }
}

pub(crate) fn length_from_energy<const D: usize>(
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> Integral {
    let energy = Interpolation::new(sequence).energy(metric);
    let value = energy.value.sqrt();
    Integral { value, error: 0.5 * energy.error / value }
}

pub(crate) fn k3_without_mean<const D: usize>(sequence: &PointSequence<D>) -> f64 {
    sequence.k3() * (sequence.n().get() as f64).sqrt()
}

pub(crate) fn christoffel_symbols<const D: usize>(
    mutant: Mutant,
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
    match mutant {
        Mutant::ChristoffelSign => christoffel_with_wrong_sign(metric, x),
        Mutant::ChristoffelDoubled => Ok(christoffel(metric, x)?.map(|symbols| symbols * 2.0)),
        _ => christoffel(metric, x),
    }
}

pub(crate) fn constants(mutant: Mutant, genuine: Constants) -> Constants {
    match mutant {
        Mutant::LipschitzTooSmall => with_l_h(genuine, 0.9),
        Mutant::LipschitzDoubled => with_l_h(genuine, 2.0),
        _ => genuine,
    }
}

pub(crate) fn region_of_c2(genuine: Region) -> Region {
    let constants = genuine.constants;
    Region { radius: genuine.radius * (constants.c1() / constants.c2()).sqrt(), ..genuine }
}

/// The discrete energy without the last chord.
fn without_last_chord<R: Rule, const D: usize>(
    rule: R,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    let mut points = sequence.points().to_vec();
    let last = points.len() - 1;
    // A chord of no length adds nothing, and N stays.
    points[last] = points[last - 1];
    rule.energy(metric, &PointSequence::new(points).expect("as many finite points"))
}

/// The gradient of the discrete energy as if `H` did not depend on the point.
fn frozen_gradient<R: Rule, const D: usize>(
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> Vec<SVector<f64, D>> {
    let n = sequence.n().get() as f64;
    let mut gradient = vec![SVector::zeros(); sequence.points().len()];
    for (k, (x, chord)) in sequence.chords().enumerate() {
        for node in R::NODES {
            let gram: SMatrix<f64, D, D> = metric.gram(&(x + chord * node.fraction));
            let force = gram * chord * (2.0 * n * node.weight);
            gradient[k] -= force;
            gradient[k + 1] += force;
        }
    }
    gradient
}

/// `Γᵏᵢⱼ = ½ Σ H⁻¹ₖₗ (∂ᵢHₗⱼ + ∂ⱼHₗᵢ + ∂ₗHᵢⱼ)`, with a plus in the last term.
fn christoffel_with_wrong_sign<const D: usize>(
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
