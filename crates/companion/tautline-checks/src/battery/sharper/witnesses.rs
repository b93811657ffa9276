//! The sharper statements where they are attained, or have the smallest overestimation known.

use tautline::{
    Constants, Ends, FiniteSet, KnownDistance, PointSequence,
    gallery::{Constant, Separable},
};
use tautline_statements::{
    Evidence, Known, PaperRule, Reconstruction,
    Statement::{
        LemmaS1, LemmaS2, LemmaS3, LemmaS4, LemmaS5, PropositionS6, TheoremA, TheoremB, TheoremC,
        TheoremD,
    },
    Subject, VerifyError, WithConstants,
    curves::BoundedCurve,
    least_length_bound, lemma_s_1, lemma_s_2, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6, theorem_a,
    theorem_b, theorem_c, theorem_d,
    witnesses::{Incline, InclineGeodesic, Twist, one_step, tent, two_routes},
};

use crate::battery::{
    cases::routes::{SLOPE, downwards, misleading, ridge, route, routes, upwards, valley},
    harness::{Check, Outcome, Trial, Witness, all, for_rules},
    paper::theorem_witnesses::{LIMIT, flat_problem},
};

pub(crate) const CHECKS: &[Check] = &[
    Witness.check("lemma_s_1_is_attained_by_a_twist_and_an_incline", &[LemmaS1], bent),
    Witness.check("lemma_s_2_is_attained_by_one_step", &[LemmaS2], steps),
    Witness.check("lemma_s_2_is_attained_along_a_parabola", &[LemmaS2], parabola),
    Witness.check(
        "lemma_s_3_and_prop_s_6_are_attained_where_the_metric_is_constant",
        &[LemmaS3, PropositionS6],
        flat,
    ),
    Witness.check(
        "lemmas_s_4_and_s_5_are_attained_on_ridges_valleys_and_inclines",
        &[LemmaS4, LemmaS5],
        one_route,
    ),
    Witness.check("lemma_s_4_has_the_second_variation_up_an_incline", &[LemmaS4], second_variation),
    Witness.check("lemma_s_5_is_attained_by_one_long_chord", &[LemmaS5], one_long_chord),
    Witness.check("theorems_a_and_c_are_attained_on_two_routes", &[TheoremA, TheoremC], two_ways),
    Witness.check("theorem_c_is_attained_by_the_left_rule_for_every_n", &[TheoremC], many_chords),
    Witness.check("theorems_b_and_d_are_attained_on_two_arcs", &[TheoremB, TheoremD], two_arcs),
];

/// The factor by which an overestimation may exceed 1, which is only attained in a limit.
pub(crate) const NEAR: f64 = 1.01;

/// Checks a short geodesic through the centre of a twist, and one at the foot of an incline.
fn bent(trial: &Trial<'_>) -> Outcome {
    fn attained<const D: usize>(
        subject: &Subject,
        metric: &impl tautline::Bounded<D>,
        curve: &impl BoundedCurve<D>,
        distance: f64,
    ) -> Result<Evidence, VerifyError> {
        lemma_s_1(subject, metric, curve, distance, 0.0)?
            .claim_is_attained("|γ̈(t)| ≤ G d/√c₁", NEAR)?
            .claim_is_attained("γ̈ᵀHγ̈ ≤ G²d²", NEAR)
    }
    let cases = (0.3..3.0, 0.1..2.0);
    trial.for_all(2800, 64, cases, |subject, (base, slope): (f64, f64)| {
        let twist = Twist::<2>::new(base, slope, 2e-3 * base / slope)?;
        let speed = 1e-5 * base / slope;
        let incline = Incline::new(base, slope).expect("positive");
        let climb = InclineGeodesic::new(base, slope, 2e-3 * base / slope)?;
        Ok([
            attained(subject, &twist, &twist.short_geodesic(speed), base.sqrt() * speed)?,
            attained(subject, &incline, &climb, climb.distance())?,
        ])
    })
}

/// Checks one step over a valley and one step up an incline, for every `N`.
fn steps(trial: &Trial<'_>) -> Outcome {
    let cases = (1..300_usize, 0.0..1.0, 0.1..10.0);
    trial.for_all(2801, 128, cases, |subject, (n, at, slope): (usize, f64, f64)| {
        let sequence = one_step(n, (at * n as f64) as usize);
        let valley = tent(2.0, slope).expect("positive");
        let incline = Incline::new(2.0, slope).expect("positive");
        Ok([
            lemma_s_2(subject, &valley, &sequence)?
                .claim_is_attained("|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³/4N", NEAR)?,
            lemma_s_2(subject, &incline, &sequence)?
                .claim_is_attained("|E(γᵖˡ) − E_l,N| ≤ L_H mean|β|³/2N", NEAR)?
                .claim_is_attained("|E_l,N − E_tra,N| ≤ L_H mean|β|³/2N", NEAR)?,
        ])
    })
}

/// At its crest `H = (1 + a sin kx)²` is nearly a parabola of curvature `2a(1 + a)k² = M_H`. Along
/// a chord of length `l` the curvature changes by a relative `(kl)²/2`.
pub(crate) fn crest() -> Result<Separable<1>, VerifyError> {
    Ok(Separable::new([1e-3], [0.3])?)
}

/// The point where `sin kx = 1`.
pub(crate) const CREST: f64 = std::f64::consts::FRAC_PI_2 / 0.3;

fn parabola(trial: &Trial<'_>) -> Outcome {
    let metric = crest()?;
    all([1, 2, 9].map(|n| {
        let at = |k: usize| [CREST - 0.25 + if 2 * k < n + 1 { 0.0 } else { 0.5 }];
        let sequence = PointSequence::new((0..=n).map(|k| at(k).into()).collect())?;
        let claim = "|E(γᵖˡ) − E_tra,N| ≤ M_H mean|β|⁴/24N²";
        trial.one([lemma_s_2(trial.subject, &metric, &sequence)?.claim_is_attained(claim, NEAR)?])
    }))
}

/// Under `H = 4 I` all speeds are `d`, and `d² = E_N`.
fn flat(trial: &Trial<'_>) -> Outcome {
    let known = flat_problem()?;
    for_rules([1, 2, 7, 100], |rule, n| {
        let seen = Reconstruction::observe(trial.subject, &known, rule, n)?;
        let speeds = lemma_s_3(trial.subject, &known.metric, rule, &seen.minimum.sequence)?
            .claim_is_attained("max qₙ ≤ √E + (L_H/c₁^{3/2})E + mean|ρ|/√c₁", NEAR)?
            .claim_is_attained("max|βₙ| ≤ (c₂K₃ + ½L_H K₃² + mean|ρ|)/c₁", NEAR)?;
        // The distance between the sets is |(3, 4)| = 5.
        let enclosure = prop_s_6(trial.subject, &seen, 5.0)?
            .claim_is_attained("lower ≤ d²", 1.0 + 1e-12)?
            .claim_is_attained("c₁ gap² ≤ d²", 1.0 + 1e-12)?
            .claim_is_attained("d² ≤ L(γᵖˡ)²", 1.0 + 1e-12)?;
        trial.one([speeds, enclosure])
    })
}

/// `N = 1` along one route, in the limit `δ → 0`. On a ridge and down an incline the rule's value
/// of `H` is too large; over a valley and up an incline it is too small.
fn one_route(trial: &Trial<'_>) -> Outcome {
    let (tra, left) = (PaperRule::Trapezoidal, PaperRule::LeftEndpoint);
    let seen = |rule, knots| route(trial.subject, rule, knots);
    let above = "E_N − d² ≤ d² (e − 1)";
    let length = "L(γᵖˡ)² − E_N ≤ its bound";
    let subject = trial.subject;
    trial.one([
        lemma_s_4(subject, &seen(tra, ridge(1.0))?).claim_is_attained(above, LIMIT)?,
        lemma_s_4(subject, &seen(left, downwards(1.0))?).claim_is_attained(above, LIMIT)?,
        lemma_s_5(subject, &seen(tra, valley(1.0))?).claim_is_attained(length, LIMIT)?,
        lemma_s_5(subject, &seen(left, upwards(1.0))?).claim_is_attained(length, LIMIT)?,
    ])
}

/// Up `H = 1 + x/100`, `M_H = 0`, and the force is `d²δ/2` all the way, to within a few `δ`. Only
/// the second variation `d²δ²/48N²` is left.
fn second_variation(trial: &Trial<'_>) -> Outcome {
    let slope = 1e-2;
    let metric = Incline::new(1.0, slope).expect("positive");
    let constants = Constants::new(1.0, 1.0 + slope, slope).and_then(|c| c.with_m_h(0.0));
    let constants = constants?.on_a_region();
    let ends = Ends::points([0.0], [1.0])?;
    let distance = metric.distance(&[0.0].into(), &[1.0].into()).expect("of [0, 1]");
    let metric = WithConstants { metric, constants };
    let known = Known { metric, ends, distance, distance_error: 4.0 * f64::EPSILON };
    all([4, 16, 64].map(|n| {
        let seen = Reconstruction::observe(trial.subject, &known, PaperRule::Trapezoidal, n)?;
        let found = lemma_s_4(trial.subject, &seen);
        trial.one([found.claim_is_attained("E_tra,N − d² ≤ d² (ê − 1)", 1.05)?])
    }))
}

/// The sequence is a straight line under a constant metric, so that `mean u = 1`, and `v = ε − 1`
/// is the variance. If all chords but one are equal, that one is as far from the mean as possible.
///
/// With `N = 100`, one speed of 8 times the mean, and `v = 49/99`, the moments lose the difference
/// between `√(s − v)` and its tangent, and the differences between `N − 2` and `N − 1` and between
/// `N² − 3N + 3` and `(N − 1)²`. The bounds are 6.200 instead of 5.914, and 46.39 instead of 41.70.
fn one_long_chord(trial: &Trial<'_>) -> Outcome {
    let metric = Constant::<1>::new([[4.0]].into()).expect("positive");
    let known = Known::between(metric, [0.0], [3.0])?.expect("known");
    for_rules([2, 3, 10, 100], |rule, n| {
        let first = if n == 100 { 0.24 } else { 2.0 };
        // The other chords divide the rest equally.
        let at = |k: usize| match k {
            0 => [0.0],
            _ => [first + (3.0 - first) * (k - 1) as f64 / (n - 1) as f64],
        };
        let mut minimum = Reconstruction::observe(trial.subject, &known, rule, n)?.minimum;
        minimum.sequence = PointSequence::new((0..=n).map(|k| at(k).into()).collect())?;
        let seen = Reconstruction::read(trial.subject, &known, rule, minimum)?;
        let mut found = lemma_s_5(trial.subject, &seen);
        if n > 2 {
            found = found
                .claim_is_attained("var u ≤ v", 1.0 + 1e-9)?
                .claim_is_attained("|u − mean u| ≤ √((N−1)v)", 1.0 + 1e-9)?;
        }
        if n == 100 {
            found = found
                .claim_is_attained("mean u³ ≤ m₃", 1.049)?
                .claim_is_attained("mean u⁴ ≤ m₄", 1.113)?;
        }
        trial.one([found])
    })
}

/// Checks two routes, of which the wrong one seems shorter by a hair; and the wrong route alone,
/// which has all of `d² − E_N`.
fn two_ways(trial: &Trial<'_>) -> Outcome {
    let subject = trial.subject;
    for_rules([1], |rule, _| {
        let knots = misleading(rule);
        let (both, alone) = (routes(subject, rule, knots)?, route(subject, rule, knots[1])?);
        let of = |theorem: fn(&Subject, &Reconstruction<1>) -> Evidence| {
            let alone = theorem(subject, &alone);
            trial.one([
                theorem_is_attained(theorem(subject, &both), LIMIT)?,
                alone.claim_is_attained("d² − E_N ≤ its bound", LIMIT)?,
            ])
        };
        let least = least_length_bound(subject, &both).overestimates_at_most(LIMIT)?;
        all([trial.one([least]), of(theorem_a), of(theorem_c)])
    })
}

/// Requires that Theorems A to D are attained on two routes.
fn theorem_is_attained(evidence: Evidence, limit: f64) -> Result<Evidence, VerifyError> {
    evidence
        .claim_is_attained("|E(γᵖˡ) − E_N| ≤ its bound", limit)?
        .claim_is_attained("E(γᵖˡ) − d² ≤ its bound", limit)?
        .claim_is_attained("L(γᵖˡ)² − d² ≤ its bound", limit)
}

/// The `n` equal chords of the first route lead over ridges, and those of the second over valleys.
/// At the points that the rule reads, the second route is lower by a thousandth, so the rule
/// prefers it. For the left rule the first route leads down an incline and the second leads up one.
/// The next term in the expansion of the excess is smaller than the leading one by a factor of `δ`,
/// or of `√N δ`.
fn many_chords(trial: &Trial<'_>) -> Outcome {
    let mut evidence = Vec::new();
    for n in [2_u32, 5, 16] {
        let l = SLOPE / f64::from(n);
        let wave = |foot: f64, height: f64| -> Vec<[f64; 2]> {
            let at = |k: u32| {
                [
                    0.5 * f64::from(k) / f64::from(n),
                    if k.is_multiple_of(2) { foot } else { foot + height },
                ]
            };
            (0..=2 * n).map(at).collect()
        };
        let low = 1.0 + 0.5 * l - 1e-3 * l;
        let start = 1.0 + l - 1e-3 * l;
        for (rule, first, second) in [
            (PaperRule::Trapezoidal, wave(1.0, 0.5 * l), wave(low + 0.5 * l, -0.5 * l)),
            (PaperRule::LeftEndpoint, downwards(1.0).to_vec(), upwards(start).to_vec()),
        ] {
            let known = two_routes(&first, &second).expect("apart");
            let seen = Reconstruction::observe(trial.subject, &known, rule, n as usize)?;
            evidence.push(theorem_is_attained(theorem_c(trial.subject, &seen), NEAR)?);
        }
    }
    trial.one(evidence)
}

/// The crest and the trough of `H = (1 + a sin kx)²` are nearly two parabolas. One chord has length
/// 1 and leads over the crest. The other leads over the trough and seems shorter by a hair, `10⁻⁸`.
///
/// `M_H d²/c₁²` is about `2ak² = 1.8 · 10⁻⁴`. It differs between crest and trough by the
/// relative amount `2a`, and along a chord by `k²/80`.
fn two_arcs(trial: &Trial<'_>) -> Outcome {
    let metric = crest()?;
    let trough = 3.0 * CREST;
    let [top, bottom] = [1.001_f64, 0.999];
    // b² bottom² = top² − 10⁻⁸
    let b = (top * top - 1e-8).sqrt() / bottom;
    let set = |[x, y]: [f64; 2]| FiniteSet::new([[x], [y]]);
    let ends =
        Ends::new(set([CREST - 0.5, trough - 0.5 * b])?, set([CREST + 0.5, trough + 0.5 * b])?)?;
    let about = |x: f64, length: f64| {
        let known = Known::between(metric, [x - 0.5 * length], [x + 0.5 * length])?;
        Ok::<_, VerifyError>(known.expect("separable"))
    };
    let distance = about(CREST, 1.0)?.distance.min(about(trough, b)?.distance);
    let known = Known { metric, ends, distance, distance_error: 1e-15 };
    let rule = PaperRule::Trapezoidal;
    let seen = Reconstruction::observe(trial.subject, &known, rule, 1)?;
    let mut evidence = Vec::new();
    for theorem in [theorem_b, theorem_d] {
        let theorem = theorem(trial.subject, &seen).expect("M_H is known");
        evidence.push(theorem_is_attained(theorem, 1.03)?);
    }
    evidence.push(least_length_bound(trial.subject, &seen).overestimates_at_most(1.03)?);
    // On the trough alone, this is d² − E_tra.
    let seen = Reconstruction::observe(trial.subject, &about(trough, 1.0)?, rule, 1)?;
    for theorem in [theorem_b, theorem_d] {
        let theorem = theorem(trial.subject, &seen).expect("M_H is known");
        evidence.push(theorem.claim_is_attained("d² − E_N ≤ its bound", 1.01)?);
    }
    trial.one(evidence)
}
