//! The sharper statements, each without one of its hypotheses.
//!
//! `c₂` is needed only for the cap `e ≤ κ` of Lemma S.4. Only Theorems A and B assume a stationary
//! sequence. Theorems C and D do not, and Theorem C is no weaker than Theorem A.

use std::f64::consts::PI;

use tautline::{Constants, Ends, PointSequence, Rule, gallery::Valleys};
use tautline_statements::{
    Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{
        LemmaS1, LemmaS2, LemmaS3, LemmaS4, LemmaS5, PropositionS6, PropositionS7, PropositionS8,
        TheoremA, TheoremB, TheoremC, TheoremD,
    },
    VerifyError, WithConstants, lemma_s_1, lemma_s_2, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6,
    prop_s_7, prop_s_8, theorem_a, theorem_b, theorem_c, theorem_d,
    witnesses::{Polygonal, Twist, one_step, tent},
};

use crate::battery::{
    cases::{
        claiming,
        clauses::{ABOVE, BELOW, LIPSCHITZ, PREMISE},
        routes::{cheap_second_route, claimed, longer_way, ridge, steep, valley},
    },
    harness::{Check, Dropped, Outcome, Trial, all, fails_without, for_rules},
    sharper::{
        convexity::slopes,
        witnesses::{CREST, crest},
    },
};

const M_H: &[&str] = &["|uᵀ D²H[w, w] u| ≤ M_H"];

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check(
        "lemmas_s_1_to_s_3_fail_where_l_h_is_understated",
        &[LemmaS1, LemmaS2, LemmaS3],
        lemmas_without_l_h,
    ),
    Dropped.check(
        "the_sharper_theorems_fail_where_l_h_is_understated",
        &[LemmaS4, LemmaS5, TheoremA, TheoremC, PropositionS6],
        theorems_without_l_h,
    ),
    Dropped.check(
        "lemma_s_2_and_theorems_b_and_d_fail_where_m_h_is_understated",
        &[LemmaS2, TheoremB, TheoremD],
        without_m_h,
    ),
    Dropped.check("lemma_s_4_fails_where_c2_is_understated", &[LemmaS4], without_c2),
    Dropped.check("prop_s_7_fails_where_c1_is_overstated", &[PropositionS7], without_c1),
    Dropped.check(
        "prop_s_7_fails_where_m_h_is_understated_across_the_chords",
        &[PropositionS7],
        without_m_h_across,
    ),
    Dropped.check(
        "theorems_a_and_c_and_prop_s_8_fail_for_a_minimiser_that_is_not_global",
        &[TheoremA, TheoremC, PropositionS8],
        not_global,
    ),
];

/// A twist, a tent and a slope, each with a claimed `L_H` that is too small. The first two attain
/// their bounds. On the slope the two chords differ in speed, which a constant metric does not
/// allow.
fn lemmas_without_l_h(_: &Trial<'_>) -> Outcome {
    let twist = Twist::<2>::new(1.0, 1.0, 0.3)?;
    let curve = twist.short_geodesic(1e-5);
    let claimed = Constants::new(0.7, 1.3, 0.2)?;
    let bent = WithConstants { metric: twist, constants: claimed };
    let valley = tent(2.0, 1.0).expect("positive");
    let constants = Constants::new(1.9, 3.0, 0.5)?;
    let shallow = WithConstants { metric: valley, constants };
    let ramp = Polygonal::new(&[[0.0, 1.0], [1.0, 2.0]]).expect("in order");
    let constants = Constants::new(0.99, 2.01, 1e-9)?;
    let ends = Ends::points([0.0], [1.0])?;
    let minimum = LIBRARY.minimise(Rule::TRAPEZOIDAL, &ramp, &ends, 2)?;
    let flat = WithConstants { metric: ramp, constants };
    let speeds = lemma_s_3(&LIBRARY, &flat, PaperRule::Trapezoidal, &minimum.sequence);
    fails_without(&[LIPSCHITZ], lemma_s_1(&LIBRARY, &bent, &curve, 1e-5, 0.0)?)?;
    fails_without(&[LIPSCHITZ], lemma_s_2(&LIBRARY, &shallow, &one_step(3, 1))?)?;
    fails_without(&[LIPSCHITZ], speeds?)
}

/// With a thousandth of the slope claimed, `δ` is `10⁻⁴`. A level route is the shorter one, but the
/// other route seems shorter to the rule. On a ridge the rule's value of `H` is too large.
fn theorems_without_l_h(_: &Trial<'_>) -> Outcome {
    let constants = [1.0, 1.25, 1e-4];
    for rule in PaperRule::BOTH {
        let cheap = cheap_second_route(rule, constants)?;
        fails_without(&[LIPSCHITZ], theorem_a(&LIBRARY, &cheap))?;
        fails_without(&[LIPSCHITZ], theorem_c(&LIBRARY, &cheap))?;
        fails_without(&[LIPSCHITZ], lemma_s_5(&LIBRARY, &cheap))?;
    }
    let dear = dear_ridge(constants)?;
    fails_without(&[LIPSCHITZ], lemma_s_4(&LIBRARY, &dear))?;
    fails_without(&[LIPSCHITZ], prop_s_6(&LIBRARY, &dear, 0.0)?)
}

/// The first route is a steep ridge with `d² = 1.025`. The rule gives 1.05 on it and therefore
/// prefers the second route, a valley, where it gives 1.04 instead of 1.065.
fn dear_ridge(constants: [f64; 3]) -> Result<Reconstruction<1>, VerifyError> {
    claimed(PaperRule::Trapezoidal, [steep(ridge(1.0)), steep(valley(1.0004))], constants)
}

/// For a crest half of its curvature is claimed; for a valley, far less than the curvature of its
/// tip.
fn without_m_h(_: &Trial<'_>) -> Outcome {
    let metric = crest()?;
    let constants =
        Constants::new(0.9, 1.1, 1e-3).and_then(|constants| constants.with_m_h(9e-5))?;
    let chord = PointSequence::straight([CREST - 0.25], [CREST + 0.25], 1)?;
    let crest = lemma_s_2(&LIBRARY, &WithConstants { metric, constants }, &chord);
    let valley = Polygonal::new(&[[0.0, 1.05], [0.5, 1.0], [1.0, 1.05]]).expect("in order");
    let constants = Constants::new(0.9, 1.1, 0.1).and_then(|constants| constants.with_m_h(1e-6));
    let known = Known::between(valley, [0.0], [1.0])?.expect("known");
    let known = claiming(known, constants?);
    let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::Trapezoidal, 1)?;
    let theorems = [theorem_b(&LIBRARY, &seen), theorem_d(&LIBRARY, &seen)];
    fails_without(M_H, crest?)?;
    all(theorems.map(|theorem| fails_without(M_H, theorem.expect("M_H is claimed"))))
}

/// If `κ = 1` were true, no `E_N` could exceed `d²`.
fn without_c2(_: &Trial<'_>) -> Outcome {
    let dear = dear_ridge([1.0, 1.0, 0.1])?;
    fails_without(&[ABOVE], lemma_s_4(&LIBRARY, &dear))
}

/// The two slopes are those of the witness, with 1.5 times `c₁` claimed.
fn without_c1(_: &Trial<'_>) -> Outcome {
    let (metric, [x, y]) = slopes([1.5, 1.6, 1.0])?;
    let evidence = prop_s_7(&LIBRARY, &metric, PaperRule::Trapezoidal, [&x, &y], 1.0)?;
    fails_without(&[BELOW], evidence)
}

/// Two chords run along the crest `x₁ = π` of the valleys, where `H = 9`, and the second derivative
/// is −6 across them and 0 along them. If the point between them moves sideways, `E_N` is convex
/// with the modulus `9 − ½ · 6 · 4²/4² = 6`, but with a tenth of the curvature claimed it would be
/// 8.5. The middle point moves by so little that no chord shows a second derivative above `10⁻⁵`
/// along itself.
fn without_m_h_across(_: &Trial<'_>) -> Outcome {
    let constants = Constants::new(8.99, 9.01, 0.01)?.with_m_h(0.6)?;
    let through =
        |x: f64| PointSequence::new([[PI, 0.0], [x, 2.0], [PI, 4.0]].map(Into::into).to_vec());
    let (metric, both) = (Valleys, [through(PI)?, through(PI + 1e-3)?]);
    let crest = WithConstants { metric, constants };
    let [x, y] = &both;
    let evidence = prop_s_7(&LIBRARY, &crest, PaperRule::Trapezoidal, [x, y], 12.0)?;
    fails_without(M_H, evidence)
}

/// The curve is twice as long as `d` under a constant metric, for which the bounds are 0.
fn not_global(_: &Trial<'_>) -> Outcome {
    for_rules([8], |rule, n| {
        let (known, longer) = longer_way(rule, n)?;
        fails_without(&[PREMISE], theorem_a(&LIBRARY, &longer))?;
        fails_without(&[PREMISE], theorem_c(&LIBRARY, &longer))?;
        fails_without(&[PREMISE], prop_s_8(&LIBRARY, &known, &longer)?)
    })
}
