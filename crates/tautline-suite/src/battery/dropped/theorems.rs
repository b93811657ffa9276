//! Theorems 1.1 to 1.4 and their constants without a hypothesis.
//!
//! `c₂` is not needed: the answer to Remark 9.2 bounds all gaps by `c₁`, `L_H` and `d`. Nor is that
//! the minimiser is one of the theorem's own rule. That a set is bounded is needed for the
//! existence of a minimiser alone (Proposition 7.1).

use tautline::{Constants, Ends, LeftEndpoint, Minimum, PointSequence, Trapezoidal, gallery};
use tautline_statements::{
    Known, LIBRARY, PaperRule, Reconstruction, Statement,
    Statement::{
        ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    VerifyError, WithConstants, theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4,
    witnesses::{Incline, Polygonal, one_step, tent, two_routes},
};

use super::super::{
    Check, Kind, Outcome,
    check::all,
    close::close,
    failing::{fails_without, holds_without},
    section_1::evidence,
    theorem_witnesses::{Knots, MARGIN, SLOPE, downwards, level, ridge, upwards, valley},
};

const ALL: &[Statement] = &[
    Theorem1_1,
    Theorem1_2,
    Theorem1_3,
    Theorem1_4,
    ConstantK3Bar,
    ConstantC1_1,
    ConstantK4Bar,
    ConstantC1_3,
];

/// A part of the claim that the minimiser is global, as far as it is needed.
const PREMISE: &str = "E_N ≤ what the proof has";

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("theorems_1_1_to_1_4_fail_where_l_h_is_understated", Kind::Dropped, ALL, |_| {
            understated_l_h()
        }),
        Check::new("theorems_1_1_to_1_4_fail_where_c1_is_overstated", Kind::Dropped, ALL, |_| {
            overstated_c1()
        }),
        Check::new("theorems_1_1_to_1_4_do_not_need_c2", Kind::Dropped, ALL, |_| understated_c2()),
        Check::new(
            "theorems_1_1_to_1_4_fail_for_a_minimiser_that_is_not_global",
            Kind::Dropped,
            ALL,
            |_| not_global(),
        ),
        Check::new("theorems_1_1_to_1_4_fail_for_other_ends", Kind::Dropped, ALL, |_| other_ends()),
        Check::new(
            "theorems_1_1_to_1_4_hold_for_the_other_rule",
            Kind::Dropped,
            &[Theorem1_1, Theorem1_2, Theorem1_3, Theorem1_4],
            |_| other_rule(),
        ),
        Check::new(
            "theorems_1_1_and_1_3_fail_for_a_minimiser_of_the_discrete_length",
            Kind::Dropped,
            &[Theorem1_1, Theorem1_3],
            |_| length_minimiser(),
        ),
    ]
}

/// A profile a hundred times as steep: of the slope 0.1.
pub(in super::super) fn steep(knots: Knots) -> Knots {
    knots.map(|[s, h]| [s, 1.0 + 0.1 / SLOPE * (h - 1.0)])
}

/// Two routes with constants that are only claimed, and the minimiser of one chord.
pub(in super::super) fn claimed(
    rule: PaperRule,
    [first, second]: [Knots; 2],
    [c1, c2, l_h]: [f64; 3],
) -> Result<Reconstruction<1>, VerifyError> {
    let constants = Constants::new(c1, c2, l_h)?;
    let Known { metric, ends, distance, distance_error } =
        two_routes(&first, &second).expect("apart");
    let known =
        Known { metric: WithConstants { metric, constants }, ends, distance, distance_error };
    Reconstruction::observe(&LIBRARY, &known, rule, 1)
}

/// A level route with `d² = 1.005`, and a second one on which the rule reads `H = 1`, though its
/// energy and its squared length are 1.025 (trapezoidal) or 1.05 (left), to a thousandth.
pub(in super::super) fn cheap_second_route(
    rule: PaperRule,
    constants: [f64; 3],
) -> Result<Reconstruction<1>, VerifyError> {
    let second = match rule {
        PaperRule::Trapezoidal => valley(1.0),
        PaperRule::LeftEndpoint => upwards(1.0),
    };
    claimed(rule, [level(1.005_f64.sqrt()), steep(second)], constants)
}

/// With a hundredth of the slope `C` is 0.001 or so. The premise of `K̄` implies what is claimed of
/// it, and so has to fall as well: on a second route of the slope 0.01 the rule reads `c₁K₃² = l²`
/// between `d²` and what it reads on the first, 1.025 and 1.05 on a ridge, 1.05 and 1.1 on an
/// incline.
fn understated_l_h() -> Outcome {
    let constants = [1.0, 1.25, 1e-4];
    let clause = "‖H(x) − H(y)‖/|x − y| ≤ L_H";
    let mut outcomes = Vec::new();
    for (rule, first, second) in [
        (PaperRule::Trapezoidal, ridge(1.0), [[0.0, 1.005], [0.51, 1.0], [1.02, 1.005]]),
        (PaperRule::LeftEndpoint, downwards(1.0), [[0.0, 1.0], [0.52, 1.005], [1.04, 1.01]]),
    ] {
        let [theorem, on_length, _, constant] =
            evidence(&LIBRARY, &cheap_second_route(rule, constants)?);
        outcomes.extend([theorem, on_length, constant].map(|e| fails_without(&[clause], e)));
        let seen = claimed(rule, [steep(first), second], constants)?;
        let [_, _, speed, _] = evidence(&LIBRARY, &seen);
        outcomes.push(fails_without(&[clause, PREMISE], speed));
    }
    all(outcomes)
}

/// With `c₁ = 100`, `δ = 10⁻⁴` and `C` is less than 0.002; and `c₁K₃²` is 100.
fn overstated_c1() -> Outcome {
    let mut outcomes = Vec::new();
    for rule in PaperRule::BOTH {
        let seen = cheap_second_route(rule, [100.0, 100.0, 0.1])?;
        let evidence = evidence(&LIBRARY, &seen);
        outcomes.extend(evidence.map(|evidence| fails_without(&["c₁ ≤ λ_min(H)"], evidence)));
    }
    all(outcomes)
}

/// With `κ = 1` where `H` is 1.05 and 1.1, on the routes that come nearest to equality.
fn understated_c2() -> Outcome {
    let mut outcomes = Vec::new();
    for (rule, first, second) in [
        (PaperRule::Trapezoidal, ridge(1.0), valley(1.0 + 0.5 * SLOPE - MARGIN)),
        (PaperRule::LeftEndpoint, downwards(1.0), upwards(1.0 + SLOPE - MARGIN)),
    ] {
        let seen = claimed(rule, [steep(first), steep(second)], [1.0, 1.0, 0.1])?;
        let evidence = evidence(&LIBRARY, &seen);
        outcomes.extend(evidence.map(|evidence| holds_without(&["λ_max(H) ≤ c₂"], evidence)));
    }
    all(outcomes)
}

/// The computed minimiser of a rule between two sets of the line.
pub(super) fn minimum(
    metric: &impl tautline::Metric<1>,
    ends: &Ends<1>,
    rule: PaperRule,
    n: usize,
) -> Result<Minimum<1>, VerifyError> {
    Ok(match rule {
        PaperRule::Trapezoidal => LIBRARY.minimise(Trapezoidal, metric, ends, n)?,
        PaperRule::LeftEndpoint => LIBRARY.minimise(LeftEndpoint, metric, ends, n)?,
    })
}

/// From `{0, 10}` to `{1, 12}` under `H = 1` the constants are `C = 0` and `K̄ = d = 1`. The way
/// from 10 to 12 is straight, and a local minimiser since the sets are discrete; it has `E = 4`.
pub(in super::super) fn longer_way(
    rule: PaperRule,
    n: usize,
) -> Result<(Known<gallery::Constant<1>, 1>, Reconstruction<1>), VerifyError> {
    let metric = gallery::Constant::<1>::new([[1.0]].into())?;
    let ends = Ends::new(
        tautline::FiniteSet::new([[0.0], [10.0]])?,
        tautline::FiniteSet::new([[1.0], [12.0]])?,
    )?;
    let known = Known { metric, ends, distance: 1.0, distance_error: 0.0 };
    let far = minimum(&metric, &Ends::points([10.0], [12.0])?, rule, n)?;
    let seen = Reconstruction::read(&LIBRARY, &known, rule, far)?;
    Ok((known, seen))
}

fn not_global() -> Outcome {
    let mut outcomes = Vec::new();
    for n in [1, 8] {
        for rule in PaperRule::BOTH {
            let evidence = evidence(&LIBRARY, &longer_way(rule, n)?.1);
            outcomes.extend(evidence.map(|evidence| fails_without(&[PREMISE], evidence)));
        }
    }
    all(outcomes)
}

/// Up an incline of slope 0.1 from 0 to 1.1 instead of 1, with `n` subintervals: `E − d² = 0.226`.
pub(super) fn beyond_the_end(rule: PaperRule, n: usize) -> Result<Reconstruction<1>, VerifyError> {
    let metric = Polygonal::new(&[[0.0, 1.0], [1.0, 1.1], [2.0, 1.2]]).expect("in order");
    let beyond = minimum(&metric, &Ends::points([0.0], [1.1])?, rule, n)?;
    let known = Known::between(metric, [0.0], [1.0])?.expect("between the knots");
    Reconstruction::read(&LIBRARY, &known, rule, beyond)
}

/// For `N = 256`, `C/√N` is less than 0.1, and `C_tra♯` in the premise more than 1. The claim on
/// `K̄` follows from that.
fn other_ends() -> Outcome {
    let mut outcomes = Vec::new();
    for rule in PaperRule::BOTH {
        let [theorem, on_length, speed, constant] = evidence(&LIBRARY, &beyond_the_end(rule, 256)?);
        outcomes
            .extend([theorem, on_length, constant].map(|e| fails_without(&["the ends lie"], e)));
        outcomes.push(holds_without(&["the ends lie"], speed));
    }
    all(outcomes)
}

/// For the minimisers of either rule all gaps are at most those of the answer to Remark 9.2, with
/// `k = ½`. For `N = 1` they are `½ d² δ (1 + O(δ))` each, far below both `C`.
fn other_rule() -> Outcome {
    let mut outcomes = Vec::new();
    for slopes in [[ridge(1.0), valley(1.0)], [downwards(1.0), upwards(1.0)]] {
        for rule in PaperRule::BOTH {
            let seen = claimed(rule, slopes.map(steep), [1.0, 1.25, 0.1])?;
            let other = match rule {
                PaperRule::Trapezoidal => {
                    [theorem_1_3(&LIBRARY, &seen), theorem_1_4(&LIBRARY, &seen)]
                }
                PaperRule::LeftEndpoint => {
                    [theorem_1_1(&LIBRARY, &seen), theorem_1_2(&LIBRARY, &seen)]
                }
            };
            outcomes.extend(other.map(|e| holds_without(&["the rule is"], e)));
        }
    }
    all(outcomes)
}

/// One step over the tent `H = 1 + L|x − ½|` has the discrete length 1 at its tip, as short as any
/// sequence from 0 to 1 can be, for every `N`; and with the left rule so has one step up an
/// incline. Their discrete energy is `N`, and that of the curve `N (1 + L/4)` and `N (1 + L/2)`:
/// nothing converges.
///
/// Theorems 1.2 and 1.4 are silent here: on the line every monotone curve has the length `d`.
fn length_minimiser() -> Outcome {
    let (n, slope) = (16, 1e-2);
    let tent = tent(1.0, slope).expect("positive");
    let sequence = one_step(n, n / 2);
    let length = LIBRARY.discrete_length(Trapezoidal, &tent, &sequence);
    // The tip is rounded off over 10⁻¹², where H is larger by as much times the slope.
    close("the discrete length", length, 1.0, 1e-12 * slope)?;
    let incline = Incline::new(1.0, slope).expect("positive");
    let tent = Known::between(tent, [0.0], [1.0]).map_err(VerifyError::from)?.expect("known");
    let incline = Known::between(incline, [0.0], [1.0]).map_err(VerifyError::from)?.expect("known");
    all([
        fails_for(&tent, PaperRule::Trapezoidal, &sequence),
        fails_for(&incline, PaperRule::LeftEndpoint, &sequence),
    ])
}

/// Theorem 1.1 or 1.3 does not apply to this sequence, and does not hold for it.
fn fails_for<M: tautline::Bounded<1>>(
    known: &Known<M, 1>,
    rule: PaperRule,
    sequence: &PointSequence<1>,
) -> Outcome {
    let mut minimum = minimum(&known.metric, &known.ends, rule, sequence.n().get())?;
    minimum.sequence = sequence.clone();
    let [theorem, ..] = evidence(&LIBRARY, &Reconstruction::read(&LIBRARY, known, rule, minimum)?);
    fails_without(&[PREMISE], theorem)
}
