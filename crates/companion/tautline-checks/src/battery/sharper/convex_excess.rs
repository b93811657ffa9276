//! Proposition S.9: random near points, the cases that attain it, and what each of its parts is
//! for.

use std::f64::consts::PI;

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    Bounded, Constants, Ends, KnownDistance, PointSequence,
    gallery::{Constant, Separable},
};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, PropositionS9},
    Subject, VerifyError, WithConstants, prop_s_9,
    witnesses::Incline,
};

use crate::battery::{
    cases::{claiming, clauses::LIPSCHITZ},
    harness::{
        Check, Dropped, Failure, Homogeneous, Outcome, Random, Trial, Witness, all, fails_without,
        for_rules,
    },
    sharper::witnesses::NEAR,
};
use crate::strategies::{
    constant, gaussian_fisher_nearby, hyperbolic_nearby, points, ramp, separable, shear,
    sphere_nearby, subintervals, valleys_across, vector,
};

const S9: &[Statement] = &[PropositionS9];

const CLAIM: &str = "E(γᵖˡ) − d² ≤ P + (K + S)²/4σ";

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_s_9_holds_for_minimisers_and_for_waves_about_them", S9, near_points),
    Homogeneous.check("prop_s_9_is_homogeneous", S9, in_units),
    Witness.check("prop_s_9_is_attained_up_an_incline", S9, incline),
    Witness.check("prop_s_9_is_attained_by_a_wave_under_a_constant_metric", S9, wave),
    Witness.check("prop_s_9_counts_what_the_left_rule_moves", S9, moved_by_the_left_rule),
    Dropped.check("prop_s_9_fails_where_l_h_is_understated", S9, without_l_h),
];

/// Evaluates the statement on a minimiser, and on the same sequence plus half a sine wave.
fn both<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    rule: PaperRule,
    n: usize,
    by: SVector<f64, D>,
) -> Result<Vec<Evidence>, VerifyError> {
    let seen = Reconstruction::observe(subject, known, rule, n)?;
    let x = &seen.minimum.sequence;
    // The wave is exactly 0 at both ends, while the computed sine is not.
    let sine = |k: usize| if k == 0 || k == n { 0.0 } else { (PI * k as f64 / n as f64).sin() };
    let moved = x.points().iter().enumerate().map(|(k, x)| x + by * sine(k));
    let waved = PointSequence::new(moved.collect())?;
    let found = [x, &waved].map(|sequence| prop_s_9(subject, known, rule, sequence));
    Ok(found.into_iter().collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// Draws problems for both rules. The size of the wave is a part of the distance of the ends, from
/// one on the scale of the excess to one that is hardly convex.
macro_rules! near {
    ($trial:ident, [$(($seed:literal, $cases:literal, $problems:expr)),* $(,)?]) => {
        all([$({
            let wave = (vector(1.0), -6.0..-0.5);
            let cases = ($problems, subintervals(), wave, any::<bool>());
            $trial.for_all($seed, $cases, cases, |subject, (known, n, (way, power), left)| {
                let rule = PaperRule::BOTH[usize::from(left)];
                both(subject, &known, rule, n, way * (known_size(&known) * 10_f64.powf(power)))
            })
        }),*])
    };
}

/// Returns the Euclidean distance of the two ends.
fn known_size<M, const D: usize>(known: &Known<M, D>) -> f64 {
    let origin = SVector::zeros();
    (known.ends.first().project(&origin) - known.ends.second().project(&origin)).norm()
}

fn near_points(trial: &Trial<'_>) -> Outcome {
    near!(
        trial,
        [
            (2900, 64, points(constant::<3>())),
            (2901, 512, points(shear())),
            (2902, 128, points(separable::<1>())),
            (2903, 256, points(separable::<2>())),
            (2904, 96, points(ramp())),
            (2905, 192, valleys_across::<2>()),
            (2906, 128, sphere_nearby::<1>()),
            (2907, 256, sphere_nearby::<3>()),
            (2908, 256, hyperbolic_nearby::<2>()),
            (2909, 256, gaussian_fisher_nearby()),
        ]
    )
}

fn in_units(trial: &Trial<'_>) -> Outcome {
    let cases = (gaussian_fisher_nearby(), subintervals(), any::<bool>());
    trial.homogeneous(2920, 128, cases, |subject, (known, n, left), units| {
        let known = units.known(known)?;
        let by = SVector::repeat(1e-3 * known_size(&known));
        both(subject, &known, PaperRule::BOTH[usize::from(left)], n, by)
    })
}

/// Requires that the statement says something.
fn said(evidence: Result<Option<Evidence>, VerifyError>) -> Result<Evidence, Failure> {
    evidence?.ok_or_else(|| Failure::new("Proposition S.9 says nothing of near points"))
}

/// A geodesic up `H = 1 + s x` from 0 to 1: `M_H = 0`, so that `K = 0` for the trapezoidal rule, and
/// only the energy of the sampled geodesic is left. It is a constant, `G²d²/12N²`, up to terms in
/// `δ = s` and `1/N`.
fn incline(trial: &Trial<'_>) -> Outcome {
    let slope = 1e-3;
    let metric = Incline::new(1.0, slope).expect("positive");
    let constants = Constants::new(1.0, 1.0 + slope, slope)?.with_m_h(0.0)?.on_a_region();
    let ends = Ends::points([0.0], [1.0])?;
    let distance = metric.distance(&[0.0].into(), &[1.0].into()).expect("of [0, 1]");
    let metric = WithConstants { metric, constants };
    let known = Known { metric, ends, distance, distance_error: 4.0 * f64::EPSILON };
    all([2, 8, 32].map(|n| {
        let seen = Reconstruction::observe(trial.subject, &known, PaperRule::Trapezoidal, n)?;
        let sequence = &seen.minimum.sequence;
        let found = said(prop_s_9(trial.subject, &known, seen.rule, sequence))?;
        trial.one([found.claim_is_attained(CLAIM, NEAR)?])
    }))
}

/// Under a constant metric the excess of a straight line plus half a sine wave is exactly
/// `S²/4σ`.
fn wave(trial: &Trial<'_>) -> Outcome {
    let metric = Constant::<2>::new([[4.0, 0.0], [0.0, 4.0]].into()).expect("positive");
    let known = Known::between(metric, [0.0, 0.0], [1.0, 2.0])?.expect("known");
    for_rules([2, 5, 32], |rule, n| {
        let found = both(trial.subject, &known, rule, n, [0.1, 0.2].into())?;
        let waved = found.into_iter().next_back().expect("two sequences");
        trial.one([waved.claim_is_attained(CLAIM, 1.0 + 1e-9)?])
    })
}

/// Over `f = 1 + a sin πx` from 0 to 1 the slope of `H` is `2πa cos πx`. The left-endpoint rule reads
/// too small values on the way up and too large ones on the way down, and moves its points. Without
/// `K` the bound would be an eighth of the excess.
fn moved_by_the_left_rule(trial: &Trial<'_>) -> Outcome {
    let known = hill()?;
    all([64, 512].map(|n| {
        let seen = Reconstruction::observe(trial.subject, &known, PaperRule::LeftEndpoint, n)?;
        let sequence = &seen.minimum.sequence;
        let found = said(prop_s_9(trial.subject, &known, seen.rule, sequence))?;
        trial.one([found.claim_is_attained(CLAIM, 8.0)?])
    }))
}

fn hill() -> Result<Known<Separable<1>, 1>, VerifyError> {
    Ok(Known::between(Separable::new([1e-3], [PI])?, [0.0], [1.0])?.expect("known"))
}

/// The same hill, with almost no slope claimed.
fn without_l_h(_: &Trial<'_>) -> Outcome {
    let known = hill()?;
    let true_to = known.metric.constants();
    let m_h = true_to.m_h().expect("known");
    let constants = Constants::new(true_to.c1(), true_to.c2(), 1e-9)?.with_m_h(m_h)?;
    let known = claiming(known, constants);
    let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::LeftEndpoint, 64)?;
    let found = said(prop_s_9(&LIBRARY, &known, seen.rule, &seen.minimum.sequence))?;
    fails_without(&[LIPSCHITZ], found)
}
