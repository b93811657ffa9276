//! Proposition S.8 where only its margin is lost, and where it fails.

use tautline::{
    Ball, Constants, Ends, HalfSpace, LocallyBounded,
    gallery::{Constant, Sphere},
};
use tautline_statements::{
    Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, PropositionS8},
    VerifyError, WithConstants, prop_s_8,
};

use crate::battery::harness::{
    Check,
    Kind::{Dropped, Witness},
    Outcome, Trial, fails_without,
};

const S8: &[Statement] = &[PropositionS8];

/// The margin of the radius, `1.01 (1 + 10⁻⁵)`, and what a small ball adds.
const PERCENT: f64 = 1.0102;

pub(crate) const CHECKS: &[Check] = &[
    Witness.check("prop_s_8_is_attained_where_the_metric_is_constant", S8, flat),
    Witness.check("prop_s_8_is_attained_in_a_small_ball", S8, small),
    Dropped.check("prop_s_8_fails_where_c1_is_overstated", S8, without_c1),
];

fn on_the_plane(factor: f64) -> Result<Constant<2>, VerifyError> {
    Ok(Constant::new([[factor, 0.0], [0.0, factor]].into())?)
}

/// `H = 4 I`: between points, and from a half-plane to a ball, where the last end is the bounded
/// one.
fn flat(trial: &Trial<'_>) -> Outcome {
    let metric = on_the_plane(4.0)?;
    let points = Known::between(metric, [1.0, 0.0], [4.0, 4.0])?;
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0)?;
    let ball = Ball::new([0.0, 0.0], 1.0)?;
    let ends = Ends::new(wall, ball)?;
    let sets = Known { metric, ends, distance: 4.0, distance_error: 0.0 };
    let mut evidence = Vec::new();
    for known in [points.expect("known"), sets] {
        for rule in PaperRule::BOTH {
            for n in [1, 2, 7, 100] {
                let seen = Reconstruction::observe(trial.subject, &known, rule, n)?;
                evidence.push(
                    prop_s_8(trial.subject, &known, &seen)?
                        .claim_is_attained("|xₙ − x| ≤ R", PERCENT)?
                        .claim_is_attained("d ≤ √c₁ R", PERCENT)?
                        .claim_is_attained("√c₁ R ≤ L(γ) on the way out", 1.0 + 1e-12)?,
                );
            }
        }
    }
    trial.one(evidence)
}

/// Two points so close that the sphere is flat between them.
fn small(trial: &Trial<'_>) -> Outcome {
    let (a, b) = ([0.5, 0.0], [0.500_006, 0.000_008]);
    let constants = Sphere.constants_within(&a.into(), 1.02e-5)?;
    let metric = WithConstants { metric: Sphere, constants };
    let known = Known::between(metric, a, b)?.expect("known");
    let mut evidence = Vec::new();
    for rule in PaperRule::BOTH {
        let seen = Reconstruction::observe(trial.subject, &known, rule, 4)?;
        evidence.push(
            prop_s_8(trial.subject, &known, &seen)?
                .claim_is_attained("|xₙ − x| ≤ R", PERCENT)?
                .claim_is_attained("d ≤ √c₁ R", PERCENT)?
                .claim_is_attained("√c₁ R ≤ L(γ) on the way out", PERCENT)?,
        );
    }
    trial.one(evidence)
}

/// `H = I` with twice its `c₁`: the other end is `√2/1.01` times as far away as the radius.
fn without_c1(_: &Trial<'_>) -> Outcome {
    let constants = Constants::new(2.0, 2.0, 0.0)?;
    let metric = WithConstants { metric: on_the_plane(1.0)?, constants };
    let ends = Ends::points([0.0, 0.0], [1.0, 0.0])?;
    let known = Known { metric, ends, distance: 1.0, distance_error: 0.0 };
    let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::Trapezoidal, 4)?;
    fails_without(&["c₁ ≤ λ_min(H)"], prop_s_8(&LIBRARY, &known, &seen)?)
}
