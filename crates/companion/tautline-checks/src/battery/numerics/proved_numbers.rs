//! Statements evaluated on proved numbers: energies and lengths are computed with outward rounding,
//! and constants are proved from the formula alone.

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    CertifyError, Interval, Jet1, Metric, PointSequence, Polygon, Quantity, Rule, Scalar,
    certify::{Accuracy, Domain, certify},
    gallery::Valleys,
};
use tautline_statements::{
    Evidence,
    Statement::{
        self, Proposition3_3, Proposition6_1, Proposition7_9, Proposition7_10, Proposition8_1,
        Proposition8_2,
    },
    Unit, VerifyError,
};

use crate::battery::harness::{Check, Outcome, Proved, Trial, for_all};
use crate::strategies::{separable, sequence, shear};

const GAPS: &[Statement] = &[Proposition6_1, Proposition7_9, Proposition8_1, Proposition8_2];
const ALL: &[Statement] = &[
    Proposition3_3,
    Proposition6_1,
    Proposition7_9,
    Proposition7_10,
    Proposition8_1,
    Proposition8_2,
];

pub(crate) const CHECKS: &[Check] = &[
    Proved.check("statements_hold_for_numbers_that_are_proved", ALL, hold),
    Proved.check("energies_and_lengths_lie_between_their_bounds", GAPS, lie_between),
];

/// Returns `c₁`, `c₂` and `L_H` of a periodic metric, proved on all of space to one percent and
/// rounded to the safe side.
fn constants<const D: usize>(metric: &impl Metric<D>) -> Result<[Interval; 3], VerifyError> {
    let space = Domain::space(metric);
    if !space.is_all_of_space() {
        return Err(CertifyError::NotAllOfSpace.into());
    }
    let accuracy = Accuracy { tolerance: 1e-2, ..Accuracy::default() };
    let of = |quantity| certify(metric, quantity, &space, accuracy);
    let (c1, c2, l_h) = (of(Quantity::C1)?, of(Quantity::C2)?, of(Quantity::LH)?);
    Ok([c1.lower, c2.upper, l_h.upper].map(Interval::point))
}

fn square<const D: usize>(x: &SVector<Interval, D>) -> Interval {
    x.iter().fold(Interval::constant(0.0), |sum, x| sum + x.sqr())
}

fn difference<const D: usize>(x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<Interval, D> {
    SVector::from_fn(|i, _| Interval::point(y[i]) - Interval::point(x[i]))
}

/// Evaluates a conclusion at the worst ends of its enclosures; if it holds there, it is proved.
fn proved(
    statement: Statement,
    claim: &'static str,
    unit: Unit,
    [observed, bound]: [Interval; 2],
) -> Evidence {
    // At equality the enclosures overlap, and nothing more can be proved.
    let granted = observed.width() + bound.width();
    Evidence::of(statement).stated(claim, unit, [observed.hi(), bound.lo()], granted)
}

fn evidence<const D: usize>(
    metric: &impl Metric<D>,
    points: &PointSequence<D>,
) -> Result<Vec<Evidence>, VerifyError> {
    let [c1, c2, l_h] = constants(metric)?;
    let n = points.n().get() as f64;
    let polygon = Polygon::new(points);
    let (energy, length) = polygon.energy_and_length(metric);
    let trapezoidal = polygon.discrete_energy(Rule::TRAPEZOIDAL, metric);
    let left = polygon.discrete_energy(Rule::LEFT_ENDPOINT, metric);
    let vertices = points.points();
    let squares = vertices.windows(2).map(|w| square(&difference(&w[0], &w[1])));
    let k3 = (squares.fold(Interval::constant(0.0), |sum, s| sum + s) * n).sqrt();
    let unit = l_h * k3.powi(3) / Interval::point(n).sqrt();
    let gap = |a: Interval, b: Interval| {
        let gap = a - b;
        Interval::new(gap.mignitude(), gap.magnitude()).unwrap_or(Interval::UNDEFINED)
    };
    let apart = square(&difference(points.first(), points.last()));
    let straight = PointSequence::new(vec![*points.first(), *points.last()])?;
    let straight = Polygon::new(&straight).energy(metric);
    let mut found = vec![
        proved(Proposition3_3, "c₁|x − y|² ≤ L(γ)²", Unit::ENERGY, [c1 * apart, length.sqr()]),
        proved(Proposition3_3, "E([x, y]) ≤ c₂|x − y|²", Unit::ENERGY, [straight, c2 * apart]),
        proved(Proposition6_1, "L(γᵖˡ)² ≤ E(γᵖˡ)", Unit::ENERGY, [length.sqr(), energy]),
        proved(
            Proposition7_9,
            "|E(γᵖˡ) − E_tra,N| ≤ L_H K₃³/4√N",
            Unit::ENERGY,
            [gap(energy, trapezoidal), unit * 0.25],
        ),
        proved(
            Proposition8_1,
            "|E_l,N − E_tra,N| ≤ L_H K₃³/2√N",
            Unit::ENERGY,
            [gap(left, trapezoidal), unit * 0.5],
        ),
        proved(
            Proposition8_2,
            "|E(γᵖˡ) − E_l,N| ≤ L_H K₃³/2√N",
            Unit::ENERGY,
            [gap(energy, left), unit * 0.5],
        ),
    ];
    let x: [Interval; D] = std::array::from_fn(|i| Interval::point(points.first()[i]));
    let gram = metric.gram(&SVector::from(Jet1::variables(&x)));
    let slopes = gram.iter().flat_map(|entry| entry.gradient().iter().map(|s| s.magnitude()));
    let steepest = Interval::point(slopes.fold(0.0, f64::max));
    found.push(proved(Proposition7_10, "|∂ₗ Hᵢⱼ| ≤ L_H", Unit::GRAM_SLOPE, [steepest, l_h]));
    Ok(found)
}

fn hold(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        32,
        [
            (3301, (shear(), sequence(3.0))),
            (3302, (separable::<2>(), sequence(3.0))),
            (3303, (Just(Valleys), sequence::<1>(3.0))),
            (3304, (Just(Valleys), sequence::<3>(3.0))),
        ],
        |_, (metric, sequence)| evidence(&metric, &sequence)
    )
}

/// The numbers computed in doubles lie between the proved bounds, to within their own errors. The
/// bounds are so narrow that no other quantity would lie between them.
fn lie_between(trial: &Trial<'_>) -> Outcome {
    trial.for_all(3311, 64, (shear(), sequence::<2>(3.0)), |subject, (metric, points)| {
        let polygon = Polygon::new(&points);
        let (energy, length) = polygon.energy_and_length(&metric);
        let (curve, long) =
            (subject.curve_energy(&metric, &points), subject.curve_length(&metric, &points));
        let [trapezoidal, left] = [
            subject.discrete_energy(Rule::TRAPEZOIDAL, &metric, &points),
            subject.discrete_energy(Rule::LEFT_ENDPOINT, &metric, &points),
        ];
        let [proved, proved_left] = [
            polygon.discrete_energy(Rule::TRAPEZOIDAL, &metric),
            polygon.discrete_energy(Rule::LEFT_ENDPOINT, &metric),
        ];
        let pairs = [
            (Proposition7_9, Unit::ENERGY, trapezoidal, 0.0, proved),
            (Proposition8_1, Unit::ENERGY, left, 0.0, proved_left),
            (Proposition8_2, Unit::ENERGY, curve.value, curve.error, energy),
            (Proposition6_1, Unit::LENGTH, long.value, long.error, length),
        ];
        let outside =
            |value: f64, bounds: Interval| (bounds.lo() - value).max(value - bounds.hi()).max(0.0);
        Ok(pairs.map(|(statement, unit, value, error, bounds)| {
            // Each nonnegative term has a dozen roundings.
            let granted = error + 1e-14 * bounds.hi();
            let observed = [outside(value, bounds), 0.0];
            Evidence::of(statement).sharper("lies in its enclosure", unit, observed, granted)
        }))
    })
}
