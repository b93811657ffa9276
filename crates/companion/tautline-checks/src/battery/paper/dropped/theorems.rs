//! Theorems 1.1 to 1.4 and their constants, each without one of its hypotheses.
//!
//! `c₂` is not needed, since the answer to Remark 9.2 bounds all gaps in terms of `c₁`, `L_H` and
//! `d`. It is not needed either that the minimiser belongs to the theorem's own rule. A bounded set
//! is needed only for the existence of a minimiser (Proposition 7.1).

use tautline::{PointSequence, Rule};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{
        self, ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    Subject, theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4,
    witnesses::{Incline, one_step, tent},
};

use crate::battery::{
    cases::{
        clauses::{ABOVE, BELOW, ENDS, LIPSCHITZ, PREMISE},
        routes::{
            beyond_the_end, cheap_second_route, claimed, downwards, longer_way, misleading, ridge,
            steep, upwards, valley,
        },
    },
    harness::{
        Check, Dropped, Outcome, Trial, all, close, fails_without, for_rules, holds_without,
    },
    paper::section_1::of_minimiser,
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

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check("theorems_1_1_to_1_4_fail_where_l_h_is_understated", ALL, understated_l_h),
    Dropped.check("theorems_1_1_to_1_4_fail_where_c1_is_overstated", ALL, overstated_c1),
    Dropped.check("theorems_1_1_to_1_4_do_not_need_c2", ALL, understated_c2),
    Dropped.check("theorems_1_1_to_1_4_fail_for_a_minimiser_that_is_not_global", ALL, not_global),
    Dropped.check("theorems_1_1_to_1_4_fail_for_other_ends", ALL, other_ends),
    Dropped.check(
        "theorems_1_1_to_1_4_hold_for_the_other_rule",
        &[Theorem1_1, Theorem1_2, Theorem1_3, Theorem1_4],
        other_rule,
    ),
    Dropped.check(
        "theorems_1_1_and_1_3_fail_for_a_minimiser_of_the_discrete_length",
        &[Theorem1_1, Theorem1_3],
        length_minimiser,
    ),
];

/// With `L_H = 10⁻⁴` claimed, `C` is about 0.001. The claim on `K̄` follows from its premise, so
/// the premise has to fail as well. On a second route of slope 0.01 the rule gives `c₁K₃² = l²`,
/// which lies between `d²` and its value on the first route. `d²` and this value are 1.025 and 1.05
/// on a ridge, 1.05 and 1.1 on an incline.
fn understated_l_h(_: &Trial<'_>) -> Outcome {
    let constants = [1.0, 1.25, 1e-4];
    for (rule, first, second) in [
        (PaperRule::Trapezoidal, ridge(1.0), [[0.0, 1.005], [0.51, 1.0], [1.02, 1.005]]),
        (PaperRule::LeftEndpoint, downwards(1.0), [[0.0, 1.0], [0.52, 1.005], [1.04, 1.01]]),
    ] {
        let [theorem, on_length, _, constant] =
            of_minimiser(&LIBRARY, &cheap_second_route(rule, constants)?);
        all([theorem, on_length, constant].map(|e| fails_without(&[LIPSCHITZ], e)))?;
        let seen = claimed(rule, [steep(first), second], constants)?;
        let [_, _, speed, _] = of_minimiser(&LIBRARY, &seen);
        fails_without(&[LIPSCHITZ, PREMISE], speed)?;
    }
    Ok(Default::default())
}

/// With `c₁ = 100`, `δ = 10⁻⁴` and `C` is less than 0.002, while `c₁K₃²` is 100.
fn overstated_c1(_: &Trial<'_>) -> Outcome {
    for_rules([1], |rule, _| {
        let seen = cheap_second_route(rule, [100.0, 100.0, 0.1])?;
        all(of_minimiser(&LIBRARY, &seen).map(|e| fails_without(&[BELOW], e)))
    })
}

/// `κ = 1` is claimed where `H` reaches 1.05 and 1.1, on the routes that come closest to equality.
fn understated_c2(_: &Trial<'_>) -> Outcome {
    for_rules([1], |rule, _| {
        let seen = claimed(rule, misleading(rule).map(steep), [1.0, 1.0, 0.1])?;
        all(of_minimiser(&LIBRARY, &seen).map(|e| holds_without(&[ABOVE], e)))
    })
}

fn not_global(_: &Trial<'_>) -> Outcome {
    for_rules([1, 8], |rule, n| {
        let (_, seen) = longer_way(rule, n)?;
        all(of_minimiser(&LIBRARY, &seen).map(|e| fails_without(&[PREMISE], e)))
    })
}

/// For `N = 256`, `C/√N` is less than 0.1, while `C_tra♯` in the premise is more than 1. The claim
/// on `K̄` follows from the premise.
fn other_ends(_: &Trial<'_>) -> Outcome {
    for_rules([256], |rule, n| {
        let seen = beyond_the_end(rule, n)?;
        let [theorem, on_length, speed, constant] = of_minimiser(&LIBRARY, &seen);
        all([theorem, on_length, constant].map(|e| fails_without(&[ENDS], e)))?;
        holds_without(&[ENDS], speed)
    })
}

/// For the minimisers of either rule, the answer to Remark 9.2 with `k = ½` bounds all gaps. For
/// `N = 1` each gap is `½ d² δ (1 + O(δ))`, which is far below both constants `C`.
fn other_rule(_: &Trial<'_>) -> Outcome {
    let theorems: [fn(&Subject, &Reconstruction<1>) -> Evidence; 4] =
        [theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4];
    let slopes = [[ridge(1.0), valley(1.0)], [downwards(1.0), upwards(1.0)]];
    all(slopes.map(|slopes| {
        for_rules([1], |rule, _| {
            let seen = claimed(rule, slopes.map(steep), [1.0, 1.25, 0.1])?;
            let other = match rule {
                PaperRule::Trapezoidal => &theorems[2..],
                PaperRule::LeftEndpoint => &theorems[..2],
            };
            let evidence = other.iter().map(|theorem| theorem(&LIBRARY, &seen));
            all(evidence.map(|e| holds_without(&["the rule is"], e)))
        })
    }))
}

/// For every `N`, one step over the tent `H = 1 + L|x − ½|`, evaluated at its tip, has discrete
/// length 1, which is the minimum over sequences from 0 to 1. For the left rule one step up an
/// incline has this length too. The discrete energies are `N`, while the energies of the curves are
/// `N (1 + L/4)` and `N (1 + L/2)`, so that nothing converges.
///
/// Theorems 1.2 and 1.4 do not fail here, since on the line every monotone curve has the length
/// `d`.
fn length_minimiser(_: &Trial<'_>) -> Outcome {
    let (n, slope) = (16, 1e-2);
    let tent = tent(1.0, slope).expect("positive");
    let sequence = one_step(n, n / 2);
    let length = LIBRARY.discrete_length(Rule::TRAPEZOIDAL, &tent, &sequence);
    // The tip is rounded off over a width of 10⁻¹², which increases H by this width times the
    // slope.
    close("the discrete length", length, 1.0, 1e-12 * slope)?;
    let incline = Incline::new(1.0, slope).expect("positive");
    let tent = Known::between(tent, [0.0], [1.0])?.expect("known");
    let incline = Known::between(incline, [0.0], [1.0])?.expect("known");
    all([
        fails_for(&tent, PaperRule::Trapezoidal, &sequence),
        fails_for(&incline, PaperRule::LeftEndpoint, &sequence),
    ])
}

/// Requires that Theorem 1.1 or 1.3 fails for this sequence, which is not a minimiser.
fn fails_for<M: tautline::Bounded<1>>(
    known: &Known<M, 1>,
    rule: PaperRule,
    sequence: &PointSequence<1>,
) -> Outcome {
    let mut minimum =
        LIBRARY.minimise(rule.into(), &known.metric, &known.ends, sequence.n().get())?;
    minimum.sequence = sequence.clone();
    let [theorem, ..] =
        of_minimiser(&LIBRARY, &Reconstruction::read(&LIBRARY, known, rule, minimum)?);
    fails_without(&[PREMISE], theorem)
}
