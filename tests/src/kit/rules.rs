//! Runs the kit on the rules of the project, and on a rule that a user wrote.

use tautline::Rule;
use tautline_kit::{Fault, RuleCase, prelude::*, rule};

use super::{broken, fault};

#[test]
fn the_rules_of_the_library_satisfy_all_laws() {
    for rule in Rule::ALL {
        let report = verify_rule(*rule, &Effort::default());
        assert!(report.holds(), "{rule}: {report}");
    }
}

/// The guide has a table of the rules, with their names in files and in Rust.
#[test]
fn the_guide_lists_every_rule() {
    let page = include_str!("../../../guide/pages/conventions.md");
    let cells = |row: &'static str| row.split('|').map(str::trim).collect::<Vec<_>>();
    let rows = page.lines().map(cells);
    let found: Vec<_> =
        rows.filter(|cells| cells.get(1).is_some_and(|x| x.starts_with("`\""))).collect();
    assert_eq!(found.len(), Rule::ALL.len());
    for (cells, name) in found.iter().zip(Rule::NAMES) {
        assert_eq!(cells[1], format!("`\"{name}\"`"));
        assert_eq!(cells[2], format!("`Rule::{}`", name.to_uppercase()));
    }
}

/// The rule of three eighths, written as a user would write it.
const THREE_EIGHTHS: Rule = Rule::new(
    "three_eighths",
    &[
        Node { fraction: 0.0, weight: 1.0 / 8.0 },
        Node { fraction: 1.0 / 3.0, weight: 3.0 / 8.0 },
        Node { fraction: 2.0 / 3.0, weight: 3.0 / 8.0 },
        Node { fraction: 1.0, weight: 1.0 / 8.0 },
    ],
    2,
);

rule_suite!(three_eighths: THREE_EIGHTHS);

/// A rule with nodes at both ends of the chord, weights that are too small, and an exponent that is
/// too large.
const WRONG: Rule = Rule::new(
    "wrong",
    &[Node { fraction: 1.0, weight: 0.7 }, Node { fraction: 0.0, weight: 0.2 }],
    2,
);

#[test]
fn a_wrong_rule_fails_by_the_laws_it_breaks() {
    let report = verify_rule(WRONG, &Effort::default());
    let failures: Vec<&str> = report.failures().map(|outcome| outcome.id).collect();
    let broken = [
        "weights_are_nonnegative_and_sum_to_1",
        "constant_metrics_are_integrated_exactly",
        "error_exponent_is_observed",
    ];
    assert_eq!(failures, broken, "{report}");
}

/// The right-endpoint rule is valid except for its exponent, and the fault shows both exponents.
#[test]
fn an_exponent_that_is_not_observed_is_named() {
    const MISTAKEN: Rule = Rule::new("mistaken", &[Node { fraction: 1.0, weight: 1.0 }], 2);
    let report = verify_rule(MISTAKEN, &Effort::default());
    let failures: Vec<_> = report.failures().collect();
    let [outcome] = failures[..] else { panic!("{report}") };
    let Fault::Order { found, least, .. } = fault(outcome.clone()) else { panic!("{report}") };
    assert!((found - 1.0).abs() <= 0.05 && least > 1.9, "{report}");
}

/// Makes the case of a rule with these nodes and weights.
macro_rules! rule {
    ($(($fraction:expr, $weight:expr)),*) => {{
        const SOME: Rule = Rule::new("some", &[$(Node { fraction: $fraction, weight: $weight }),*], 1);
        RuleCase::new(SOME, Effort::default())
    }};
}

#[test]
fn a_node_beyond_either_end_of_the_chord_is_refused() {
    let before = rule::nodes_lie_on_the_chord(&rule![(-0.1, 0.5), (0.5, 0.5)]);
    assert_eq!(broken(before), "0 ≤ fraction");
    let behind = rule::nodes_lie_on_the_chord(&rule![(0.5, 0.5), (1.1, 0.5)]);
    assert_eq!(broken(behind), "fraction ≤ 1");
    assert!(rule::nodes_lie_on_the_chord(&rule![(0.0, 0.5), (1.0, 0.5)]).holds());
}

/// The weights add up to 1 and both nodes lie on the chord; only the sign of a weight is wrong.
#[test]
fn a_negative_weight_is_refused() {
    let case = rule![(0.0, 1.5), (1.0, -0.5)];
    assert_eq!(broken(rule::weights_are_nonnegative_and_sum_to_1(&case)), "0 ≤ weight");
    assert!(rule::nodes_lie_on_the_chord(&case).holds());
}

#[test]
fn weights_that_do_not_add_up_to_1_are_refused() {
    for outcome in [
        rule::weights_are_nonnegative_and_sum_to_1(&rule![(0.0, 0.5), (1.0, 0.499)]),
        rule::weights_are_nonnegative_and_sum_to_1(&rule![(0.0, 0.5), (1.0, 0.5 + 1e-9)]),
    ] {
        assert_eq!(broken(outcome), "|Σ weights − 1| = 0");
    }
}
