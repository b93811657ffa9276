//! The sharper statements, as laws of a metric.

use tautline_statements::{
    LIBRARY, PaperRule, Reconstruction, lemma_s_2, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6,
    prop_s_8, prop_s_9, theorem_a, theorem_b, theorem_c, theorem_d,
};

use super::{
    Case,
    statements::{judge, judge_all},
};
use crate::report::LawResult;

/// Checks Lemmas S.2 and S.3.
pub(super) fn of_sequences<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let gaps = case.of_point_sequences(lemma_s_2)?;
    let trapezoidal = case
        .of_point_sequences(|s, m, sequence| lemma_s_3(s, m, PaperRule::Trapezoidal, sequence))?;
    let left = case
        .of_point_sequences(|s, m, sequence| lemma_s_3(s, m, PaperRule::LeftEndpoint, sequence))?;
    Ok(gaps.and(trapezoidal).and(left))
}

/// Checks Lemmas S.4 and S.5. If the ends touch, there is no speed to compare with.
pub(super) fn of_minima<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| {
        let seen = minimiser.seen;
        let speeds = (seen.distance_squared > 0.0).then(|| lemma_s_5(&LIBRARY, seen));
        judge_all([lemma_s_4(&LIBRARY, seen)].into_iter().chain(speeds))
    })
}

/// Checks Theorems A to D.
pub(super) fn theorems<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let theorems = |seen: &Reconstruction<D>| -> Vec<_> {
        let first_order = [theorem_a(&LIBRARY, seen), theorem_c(&LIBRARY, seen)];
        let second_order = [theorem_b(&LIBRARY, seen), theorem_d(&LIBRARY, seen)];
        first_order.into_iter().chain(second_order.into_iter().flatten()).collect()
    };
    let solved = case.of_both_rules(&|minimiser| judge_all(theorems(minimiser.seen)))?;
    let trapezoidal = case.of_proved(PaperRule::Trapezoidal, &theorems)?;
    Ok(solved.and(trapezoidal).and(case.of_proved(PaperRule::LeftEndpoint, &theorems)?))
}

/// Checks Proposition S.6, and Proposition S.9 where convexity is proved.
pub(super) fn enclosures<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| {
        let (known, seen) = (minimiser.known, minimiser.seen);
        let convex = prop_s_9(&LIBRARY, known, seen.rule, &seen.minimum.sequence)?;
        judge_all([prop_s_6(&LIBRARY, seen, 0.0)?].into_iter().chain(convex))
    })
}

/// Checks Proposition S.8.
pub(super) fn localities<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| judge(&prop_s_8(&LIBRARY, minimiser.known, minimiser.seen)?))
}
