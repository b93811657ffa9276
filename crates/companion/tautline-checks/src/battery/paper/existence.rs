//! Proposition 7.1: the discrete energies have minimisers, and the solver finds critical points.

use nalgebra::{SMatrix, SVector};
use tautline::{
    Ball, Bounded, ClosedSet, Constants, Ends, HalfSpace, PointSequence, SetError,
    gallery::{Constant, Sphere},
};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, Proposition7_1},
    Subject, VerifyError, WithConstants, critical_point, prop_7_1,
    witnesses::tent,
};

use crate::battery::{
    cases::{AboveExponential, admissible, clauses::BELOW},
    harness::{
        Check, Dropped, Failure, Homogeneous, Outcome, Random, Trial, Witness, all, fails_without,
        for_all, for_rules,
    },
};
use crate::strategies::{
    constant_ball_half_space, points, ramp, separable_boxes, sequence, shear_ball_half_plane,
    valleys_ball_half_space,
};

const STATEMENT: &[Statement] = &[Proposition7_1];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_7_1_holds_and_minimisers_are_critical_points", STATEMENT, random),
    Homogeneous.check("prop_7_1_is_homogeneous", STATEMENT, homogeneous),
    Witness.check(
        "prop_7_1_is_attained_by_equal_steps_away_from_the_bounded_set",
        STATEMENT,
        attained,
    ),
    Dropped.check("prop_7_1_fails_where_both_sets_are_unbounded", STATEMENT, both_unbounded),
    Dropped.check("prop_7_1_fails_where_c1_is_zero", STATEMENT, on_the_sphere),
    Dropped.check(
        "prop_7_1_fails_for_another_number_of_subintervals_and_for_other_ends",
        STATEMENT,
        another_number_or_other_ends,
    ),
];

/// Evaluates the statements for both rules, each with its computed minimiser and a random sequence;
/// both minimisers must be critical points.
fn evidence<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    other: &PointSequence<D>,
) -> Result<Vec<Evidence>, VerifyError> {
    let sets: [&dyn ClosedSet<D>; 2] = [&**known.ends.first(), &**known.ends.second()];
    let mut found = Vec::new();
    for rule in PaperRule::BOTH {
        let seen = Reconstruction::observe(subject, known, rule, other.n().get())?;
        let pair = [&seen.minimum.sequence, other];
        found.push(prop_7_1(subject, rule, &known.metric, sets, pair)?);
        found.push(critical_point(subject, known, &seen));
    }
    Ok(found)
}

fn random(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        128,
        [
            (7101, (constant_ball_half_space::<3>(), sequence(3.0))),
            (7102, (shear_ball_half_plane(), sequence(3.0))),
            (7103, (separable_boxes::<2>(), sequence(3.0))),
            (7104, (valleys_ball_half_space(), sequence(3.0))),
            (7105, (points(ramp()), sequence(3.0))),
        ],
        |subject, (known, other)| {
            let other = admissible(subject, &known.ends, other)?;
            evidence(subject, &known, &other)
        }
    )
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    let problems = (shear_ball_half_plane(), sequence(3.0));
    trial.homogeneous(7110, 64, problems, |subject, (known, other), units| {
        let known = units.known(known)?;
        let other = admissible(subject, &known.ends, units.sequence(&other)?)?;
        evidence(subject, &known, &other)
    })
}

/// The sequence leads from the ball of radius 1 along its outer normal, in equal steps under
/// `H = c₁ I`. Then `|x_N − X| = Σ |xₙ₊₁ − xₙ| = √(R/c₁)`, and its energy is the least.
fn attained(trial: &Trial<'_>) -> Outcome {
    let metric = Constant::<3>::new(SMatrix::identity() * 4.0)?;
    let ball = Ball::new([1.0, 0.0, 0.0], 1.0)?;
    let wall = HalfSpace::at_least([1.0, 0.0, 0.0], 5.0)?;
    let ends = Ends::new(ball.clone(), wall.clone())?;
    for_rules([1, 3, 20], |rule, n| {
        let line = PointSequence::straight([2.0, 0.0, 0.0], [5.0, 0.0, 0.0], n)?;
        let least = trial.subject.minimise(rule.into(), &metric, &ends, n)?.sequence;
        let evidence = prop_7_1(trial.subject, rule, &metric, [&ball, &wall], [&least, &line])?;
        trial.one([evidence
            .claim_is_attained("|xₙ − X| ≤ √(R/c₁)", 1.01)?
            .claim_is_attained("Σ |xₙ₊₁ − xₙ| ≤ √(R/c₁)", 1.01)?
            .claim_is_attained("E_N(γ*) ≤ E_N(γᵖ)", 1.01)?])
    })
}

/// Requires the same as [`fails_without`], and that the conclusion `claim` fails.
fn claim_fails_without(hypothesis: &str, claim: &str, evidence: Evidence) -> Outcome {
    if evidence.conclusion(claim).holds() {
        return Err(Failure::new(format!("{claim} survives: {evidence:?}")));
    }
    fails_without(&[hypothesis], evidence)
}

/// From `{x₂ ≤ 0}` to `{x₂ ≥ e^{−x₁}}` under `H = I`, the straight line up at `x₁` has the energy
/// `e^{−2x₁}`, so that every candidate is beaten by one farther to the right. The infimum 0 is not
/// attained, and [`Ends`] refuses the pair.
fn both_unbounded(_: &Trial<'_>) -> Outcome {
    let floor = HalfSpace::new([0.0, 1.0], 0.0)?;
    let refused = Ends::new(floor.clone(), AboveExponential);
    if !matches!(refused, Err(SetError::BothUnbounded)) {
        return Err(Failure::new(format!("two unbounded sets: {refused:?}")));
    }
    let metric = Constant::<2>::new(SMatrix::identity())?;
    let up = |x1: f64| PointSequence::straight([x1, 0.0], [x1, (-x1).exp()], 4);
    for x1 in [0.0, 1.0, 5.0, 20.0] {
        let pair = [&up(x1)?, &up(x1 + 1.0)?];
        for rule in PaperRule::BOTH {
            let evidence = prop_7_1(&LIBRARY, rule, &metric, [&floor, &AboveExponential], pair)?;
            claim_fails_without("bounded", "E_N(γ*) ≤ E_N(γᵖ)", evidence)?;
        }
    }
    Ok(Default::default())
}

/// On the sphere, in stereographic coordinates, consider a chord of length at most `2r` whose
/// midpoint is at least `r/2` from the origin. Its energy is less than `N (4/(r²/4)²) 4r²`. Five
/// such chords lead round from `(1, 0)` to `(−1, 0)`. The larger `r` is, the smaller is their
/// energy, and the infimum 0 is not attained. With the claimed `c₁ = 1` they would stay within
/// `√(E/c₁)` of `(1, 0)`.
fn on_the_sphere(_: &Trial<'_>) -> Outcome {
    let claimed = Constants::new(1.0, 4.0, 4.0)?;
    let metric = WithConstants { metric: Sphere, constants: claimed };
    let ends = Ends::points([1.0, 0.0], [-1.0, 0.0])?;
    let sets: [&dyn ClosedSet<2>; 2] = [&**ends.first(), &**ends.second()];
    let out = |r: f64| {
        let points = [[1.0, 0.0], [r, 0.0], [r, r], [-r, r], [-r, 0.0], [-1.0, 0.0]];
        PointSequence::new(points.map(SVector::from).to_vec())
    };
    let mut before = f64::INFINITY;
    for r in [1e2, 1e3, 1e4] {
        let sequence = out(r)?;
        let pair = [&sequence, &sequence];
        let evidence = prop_7_1(&LIBRARY, PaperRule::Trapezoidal, &metric, sets, pair)?;
        let energy = evidence.conclusion("E_N(γ*) ≤ E_N(γᵖ)").bound;
        claim_fails_without(BELOW, "|xₙ − X| ≤ √(R/c₁)", evidence)?;
        if !(energy < before) {
            return Err(Failure::new(format!("r = {r}: {energy} after {before}")));
        }
        before = energy;
    }
    Ok(Default::default())
}

/// Over a ridge one chord has more energy than eight chords, and a straight line from set to set
/// has more energy than one that stops half-way.
fn another_number_or_other_ends(_: &Trial<'_>) -> Outcome {
    let ridge = tent(2.0, -1.5).expect("positive");
    let ends = Ends::points([0.0], [1.0])?;
    let sets: [&dyn ClosedSet<1>; 2] = [&**ends.first(), &**ends.second()];
    let least = "E_N(γ*) ≤ E_N(γᵖ)";
    let rule = PaperRule::Trapezoidal;
    let [one, eight] = [1, 8].map(|n| LIBRARY.minimise(rule.into(), &ridge, &ends, n));
    let (one, eight) = (one?.sequence, eight?.sequence);
    let half = PointSequence::straight([0.0], [0.5], 8)?;
    all([
        claim_fails_without(
            "the same N",
            least,
            prop_7_1(&LIBRARY, rule, &ridge, sets, [&one, &eight])?,
        ),
        claim_fails_without(
            "the ends lie",
            least,
            prop_7_1(&LIBRARY, rule, &ridge, sets, [&eight, &half])?,
        ),
    ])
}
