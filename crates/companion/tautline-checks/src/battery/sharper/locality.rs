//! Proposition S.8: where it loses only its margin, and where it fails.

use nalgebra::SMatrix;
use tautline::{
    Ball, Bounded, Constants, Ends, HalfSpace, LocallyBounded,
    gallery::{Constant, Sphere},
};
use tautline_statements::{
    Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, PropositionS8},
    WithConstants, prop_s_8,
};

use crate::battery::{
    cases::{claiming, clauses::BELOW},
    harness::{Check, Dropped, Outcome, Trial, Witness, all, fails_without, for_rules},
    paper::theorem_witnesses::flat_problem,
};

const S8: &[Statement] = &[PropositionS8];

/// The margin of the radius, `1.01 (1 + 10⁻⁵)`, and the amount that a small ball adds.
const PERCENT: f64 = 1.0102;

pub(crate) const CHECKS: &[Check] = &[
    Witness.check("prop_s_8_is_attained_where_the_metric_is_constant", S8, flat),
    Witness.check("prop_s_8_is_attained_in_a_small_ball", S8, small),
    Dropped.check("prop_s_8_fails_where_c1_is_overstated", S8, without_c1),
];

/// Under `H = 4 I` the bounds are attained between points, and from a half-plane to a ball, where the
/// last end is the bounded one.
fn flat(trial: &Trial<'_>) -> Outcome {
    let points = flat_problem()?;
    let ends = Ends::new(HalfSpace::at_least([1.0, 0.0], 3.0)?, Ball::new([0.0, 0.0], 1.0)?)?;
    let sets = Known { metric: points.metric, ends, distance: 4.0, distance_error: 0.0 };
    all([points, sets].map(|known| attained(trial, &known, &[1, 2, 7, 100], 1.0 + 1e-12)))
}

/// Requires, for both rules, that the radius exceeds its smallest possible value only by its
/// margin.
fn attained<M: Bounded<2>>(
    trial: &Trial<'_>,
    known: &Known<M, 2>,
    subintervals: &[usize],
    way_out: f64,
) -> Outcome {
    for_rules(subintervals.iter().copied(), |rule, n| {
        let seen = Reconstruction::observe(trial.subject, known, rule, n)?;
        trial.one([prop_s_8(trial.subject, known, &seen)?
            .claim_is_attained("|xₙ − x| ≤ R", PERCENT)?
            .claim_is_attained("|xₙ − m| ≤ ½ρ", 1.0 + 1e-4)?
            .claim_is_attained("d ≤ √c₁ R", PERCENT)?
            .claim_is_attained("√c₁ R ≤ L(γ) on the way out", way_out)?])
    })
}

/// The two points are so close together that the sphere is nearly flat between them.
fn small(trial: &Trial<'_>) -> Outcome {
    let (a, b) = ([0.5, 0.0], [0.500_006, 0.000_008]);
    let constants = Sphere.constants_within(&a.into(), 1.02e-5)?;
    let metric = WithConstants { metric: Sphere, constants };
    let known = Known::between(metric, a, b)?.expect("known");
    attained(trial, &known, &[4], PERCENT)
}

/// `H = I`, but twice its `c₁` is claimed. The distance of the other end is then `√2/1.01` times
/// the radius.
fn without_c1(_: &Trial<'_>) -> Outcome {
    let plane = Constant::<2>::new(SMatrix::identity())?;
    let known = Known::between(plane, [0.0, 0.0], [1.0, 0.0])?.expect("known");
    let known = claiming(known, Constants::new(2.0, 2.0, 0.0)?);
    let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::Trapezoidal, 4)?;
    fails_without(&[BELOW], prop_s_8(&LIBRARY, &known, &seen)?)
}
