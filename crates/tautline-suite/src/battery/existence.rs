//! Proposition 7.1: the discrete energies have minimisers, and the solver finds critical points.

use std::fmt::Debug;

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    Bounded, ClosedSet, Constants, Ends, HalfSpace, LeftEndpoint, Metric, PointSequence, SetError,
    Trapezoidal, gallery,
};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction, Statement, Statement::Proposition7_1,
    Subject, VerifyError, WithConstants, critical_point, prop_7_1, witnesses::tent,
};

use super::{
    Check, Failure, Kind, Outcome, Trial, admissible::admissible, check::all,
    failing::fails_without,
};
use crate::strategies::{
    constant_ball_half_space, points, ramp, separable_boxes, sequence, shear_ball_half_plane,
    valleys_ball_half_space,
};

const STATEMENT: &[Statement] = &[Proposition7_1];

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new(
            "prop_7_1_holds_and_minimisers_are_critical_points",
            Kind::Random,
            STATEMENT,
            random,
        ),
        Check::new("prop_7_1_is_homogeneous", Kind::Homogeneous, STATEMENT, homogeneous),
        Check::new(
            "prop_7_1_is_attained_by_equal_steps_away_from_the_bounded_set",
            Kind::Witness,
            STATEMENT,
            attained,
        ),
        Check::new(
            "prop_7_1_fails_where_both_sets_are_unbounded",
            Kind::Dropped,
            STATEMENT,
            |_| both_unbounded(),
        ),
        Check::new("prop_7_1_fails_where_c1_is_zero", Kind::Dropped, STATEMENT, |_| {
            on_the_sphere()
        }),
        Check::new(
            "prop_7_1_fails_for_another_number_of_subintervals_and_for_other_ends",
            Kind::Dropped,
            STATEMENT,
            |_| another_number_or_other_ends(),
        ),
    ]
}

/// Both rules, each with its computed minimiser and a random sequence; and both critical points.
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
    fn family<M: Bounded<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        problems: impl Strategy<Value = Known<M, D>>,
    ) -> Outcome {
        trial.for_all(seed, 128, (problems, sequence(3.0)), |subject, (known, other)| {
            let other = admissible(subject, &known.ends, other)?;
            evidence(subject, &known, &other)
        })
    }
    all([
        family(trial, 7101, constant_ball_half_space::<3>()),
        family(trial, 7102, shear_ball_half_plane()),
        family(trial, 7103, separable_boxes::<2>()),
        family(trial, 7104, valleys_ball_half_space()),
        family(trial, 7105, points(ramp())),
    ])
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    let problems = (shear_ball_half_plane(), sequence(3.0));
    trial.homogeneous(7110, 64, problems, |subject, (known, other), units| {
        let known = units.known(known)?;
        let other = admissible(subject, &known.ends, units.sequence(&other)?)?;
        evidence(subject, &known, &other)
    })
}

/// From the ball of radius 1 along its outer normal, in equal steps under `H = c₁ I`: then
/// `|x_N − X| = Σ |xₙ₊₁ − xₙ| = √(R/c₁)`, and nothing is less energetic.
fn attained(trial: &Trial<'_>) -> Outcome {
    let metric = gallery::Constant::<3>::new(SMatrix::identity() * 4.0).expect("positive definite");
    let ball = tautline::Ball::new([1.0, 0.0, 0.0], 1.0).map_err(VerifyError::from)?;
    let wall = HalfSpace::at_least([1.0, 0.0, 0.0], 5.0).map_err(VerifyError::from)?;
    let ends = Ends::new(ball, wall).map_err(VerifyError::from)?;
    let mut found = Vec::new();
    for n in [1, 3, 20] {
        let line = PointSequence::straight([2.0, 0.0, 0.0], [5.0, 0.0, 0.0], n);
        let line = line.map_err(VerifyError::from)?;
        for rule in PaperRule::BOTH {
            let least = minimiser(trial.subject, rule, &metric, &ends, n)?;
            let pair = [&least, &line];
            let evidence = prop_7_1(trial.subject, rule, &metric, [&ball, &wall], pair);
            found.push(
                evidence?
                    .claim_is_attained("|xₙ − X| ≤ √(R/c₁)", 1.01)?
                    .claim_is_attained("Σ |xₙ₊₁ − xₙ| ≤ √(R/c₁)", 1.01)?
                    .claim_is_attained("E_N(γ*) ≤ E_N(γᵖ)", 1.01)?,
            );
        }
    }
    trial.one(found)
}

/// The computed minimiser of a rule.
fn minimiser<const D: usize>(
    subject: &Subject,
    rule: PaperRule,
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    n: usize,
) -> Result<PointSequence<D>, VerifyError> {
    Ok(match rule {
        PaperRule::Trapezoidal => subject.minimise(Trapezoidal, metric, ends, n)?.sequence,
        PaperRule::LeftEndpoint => subject.minimise(LeftEndpoint, metric, ends, n)?.sequence,
    })
}

/// As [`fails_without`], with the conclusion that fails.
fn claim_fails_without(hypothesis: &str, claim: &str, evidence: Evidence) -> Outcome {
    if evidence.conclusion(claim).holds() {
        return Err(Failure::new(format!("{claim} survives: {evidence:?}")));
    }
    fails_without(&[hypothesis], evidence)
}

/// The closed set `{x₂ ≥ e^{−x₁}}` in the plane, by Newton's method for its nearest points.
#[derive(Debug)]
pub(super) struct AboveExponential;

impl ClosedSet<2> for AboveExponential {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        if x[1] >= (-x[0]).exp() {
            return *x;
        }
        // s ↦ (s − x₁)² + (e^{−s} − x₂)² is convex where e^{−s} > x₂, to the left of the root.
        let mut s = x[0];
        for _ in 0..100 {
            let e = (-s).exp();
            let slope = (s - x[0]) - e * (e - x[1]);
            s -= slope / (1.0 + e * (2.0 * e - x[1]));
        }
        SVector::from([s, (-s).exp()])
    }

    fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::identity()
    }

    fn radius(&self) -> Option<f64> {
        None
    }

    fn is_convex(&self) -> bool {
        true
    }
}

/// From `{x₂ ≤ 0}` to `{x₂ ≥ e^{−x₁}}` under `H = I`: straight up at `x₁` costs `e^{−2x₁}`, so that
/// any minimiser is beaten farther to the right. The infimum 0 is not attained, and the pair is
/// refused where ends are made.
fn both_unbounded() -> Outcome {
    let floor = HalfSpace::new([0.0, 1.0], 0.0).map_err(VerifyError::from)?;
    let refused = Ends::new(floor, AboveExponential);
    if !matches!(refused, Err(SetError::BothUnbounded)) {
        return Err(Failure::new(format!("two unbounded sets: {refused:?}")));
    }
    let metric = gallery::Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    let up = |x1: f64| PointSequence::straight([x1, 0.0], [x1, (-x1).exp()], 4);
    for x1 in [0.0, 1.0, 5.0, 20.0] {
        let (best, better) = (up(x1), up(x1 + 1.0));
        let (best, better) = (best.map_err(VerifyError::from)?, better.map_err(VerifyError::from)?);
        for rule in PaperRule::BOTH {
            let evidence =
                prop_7_1(&LIBRARY, rule, &metric, [&floor, &AboveExponential], [&best, &better])?;
            claim_fails_without("bounded", "E_N(γ*) ≤ E_N(γᵖ)", evidence)?;
        }
    }
    Ok(Default::default())
}

/// On the sphere, in stereographic coordinates, a chord of the length `2r` at most whose middle is
/// `r/2` from the origin at least costs less than `N (4/(r²/4)²) 4r²`: five of them lead round from
/// `(1, 0)` to `(−1, 0)`, the farther out the cheaper, and the infimum 0 is not attained. It is
/// claimed that they stay within `√(E/c₁)` of `(1, 0)`, with `c₁ = 1`.
fn on_the_sphere() -> Outcome {
    let claimed = Constants::new(1.0, 4.0, 4.0).map_err(VerifyError::from)?;
    let metric = WithConstants { metric: gallery::Sphere, constants: claimed };
    let ends = Ends::points([1.0, 0.0], [-1.0, 0.0]).map_err(VerifyError::from)?;
    let sets: [&dyn ClosedSet<2>; 2] = [&**ends.first(), &**ends.second()];
    let out = |r: f64| {
        let points = [[1.0, 0.0], [r, 0.0], [r, r], [-r, r], [-r, 0.0], [-1.0, 0.0]];
        PointSequence::new(points.map(SVector::from).to_vec())
    };
    let mut before = f64::INFINITY;
    for r in [1e2, 1e3, 1e4] {
        let sequence = out(r).map_err(VerifyError::from)?;
        let rule = PaperRule::Trapezoidal;
        let evidence = prop_7_1(&LIBRARY, rule, &metric, sets, [&sequence, &sequence])?;
        let energy = evidence.conclusion("E_N(γ*) ≤ E_N(γᵖ)").bound;
        claim_fails_without("c₁ ≤ λ_min(H)", "|xₙ − X| ≤ √(R/c₁)", evidence)?;
        if !(energy < before) {
            return Err(Failure::new(format!("r = {r}: {energy} after {before}")));
        }
        before = energy;
    }
    Ok(Default::default())
}

/// Over a ridge one chord is dearer than eight, and a straight line from set to set dearer than one
/// that stops half-way.
fn another_number_or_other_ends() -> Outcome {
    let ridge = tent(2.0, -1.5).expect("positive");
    let ends = Ends::points([0.0], [1.0]).map_err(VerifyError::from)?;
    let sets: [&dyn ClosedSet<1>; 2] = [&**ends.first(), &**ends.second()];
    let least = "E_N(γ*) ≤ E_N(γᵖ)";
    let rule = PaperRule::Trapezoidal;
    let [one, eight] = [1, 8].map(|n| minimiser(&LIBRARY, rule, &ridge, &ends, n));
    let (one, eight) = (one?, eight?);
    let half = PointSequence::straight([0.0], [0.5], 8).map_err(VerifyError::from)?;
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
