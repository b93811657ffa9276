//! Proposition S.10: no bound increases with the number of subintervals.

use std::num::NonZeroUsize;

use tautline::bounds::Setting;

use crate::{Evidence, PaperRule, Statement, Subject, Unit};

/// Evaluates Proposition S.10 on two numbers of subintervals: with the larger one, no bound of
/// Lemma S.4, of Theorems A to D and of Proposition S.8 is larger.
///
/// Needs: the second number is at least the first.
///
/// Equality holds for the cap `e = κ` of Lemma S.4. From one chord to two it is the caps of the
/// moments in Lemma S.5 that keep the gaps from growing.
#[must_use]
pub fn prop_s_10(
    subject: &Subject,
    setting: Setting,
    rule: PaperRule,
    [coarse, fine]: [NonZeroUsize; 2],
) -> Evidence {
    let evidence = Evidence::of(Statement::PropositionS10).given_that("N ≤ M", coarse <= fine);
    let compare = |evidence: Evidence, claim, unit, at: &dyn Fn(NonZeroUsize) -> Option<f64>| {
        match (at(fine), at(coarse)) {
            // Both are sums of nonnegative terms with a few dozen roundings; variances are
            // differences that lose up to two digits.
            (Some(of_m), Some(of_n)) => evidence.stated(claim, unit, [of_m, of_n], 1e-12 * of_n),
            _ => evidence,
        }
    };
    let of_first_order: [(_, &dyn Fn(NonZeroUsize) -> f64); 5] = [
        ("e − 1 falls", &|n| subject.theorem_a_minimum_gap(setting, rule, n)),
        ("the gap of Theorem A falls", &|n| subject.theorem_a_polyline_gap(setting, rule, n)),
        ("the gap of Theorem C falls", &|n| subject.theorem_c_polyline_gap(setting, rule, n)),
        ("the deficit of Theorem C falls", &|n| subject.theorem_c_deficit(setting, rule, n)),
        ("the least bound on L(γᵖˡ)² falls", &|n| {
            subject.least_length_excess(setting, rule, n).value
        }),
    ];
    let of_second_order: [(_, &dyn Fn(NonZeroUsize) -> Option<f64>); 5] = [
        ("e₂ − 1 falls", &|n| subject.theorem_b_minimum_gap(setting, n)),
        ("the gap of Theorem B falls", &|n| subject.theorem_b_polyline_gap(setting, n)),
        ("ε − 1 falls", &|n| subject.theorem_d_minimum_gap(setting, n)),
        ("the gap of Theorem D falls", &|n| subject.theorem_d_polyline_gap(setting, n)),
        ("the deficit of Theorem D falls", &|n| subject.theorem_d_deficit(setting, n)),
    ];
    let reach = |n| Some(subject.reach(setting, rule, n));
    let mut evidence = compare(evidence, "ρ falls", Unit::COORDINATE, &reach);
    for (claim, bound) in of_first_order {
        evidence = compare(evidence, claim, Unit::ENERGY, &|n| Some(bound(n)));
    }
    if rule == PaperRule::Trapezoidal {
        for (claim, bound) in of_second_order {
            evidence = compare(evidence, claim, Unit::ENERGY, bound);
        }
    }
    evidence
}
