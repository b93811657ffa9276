//! Wrong rules, which the laws must refuse.

use tautline::{Node, Rule};

use super::{RuleCase, laws};
use crate::{
    Fault,
    report::{LawResult, Tried},
};

/// The left-endpoint rule with a claimed exponent of 2.
const WRONG_ORDER: Rule = Rule::new("wrong_order", Rule::LEFT_ENDPOINT.nodes(), 2);

/// A rule with weights that add up to 0.9.
const LIGHT_WEIGHTS: Rule = Rule::new("light_weights", &[Node { fraction: 0.5, weight: 0.9 }], 2);

/// A rule with a node beyond the end of the chord.
const BEYOND: Rule = Rule::new(
    "beyond",
    &[Node { fraction: -0.5, weight: 0.5 }, Node { fraction: 1.5, weight: 0.5 }],
    2,
);

/// Fails if a law accepts a rule that violates it.
fn refused(
    case: &RuleCase,
    wrong: Rule,
    law: impl Fn(&RuleCase) -> LawResult,
    what: &'static str,
) -> LawResult {
    match law(&RuleCase { rule: wrong, effort: case.effort }) {
        Err(_) => Ok(Tried::cases(1)),
        Ok(_) => Err(case.effort.failure(Fault::NotRefused { what })),
    }
}

/// Checks that weights that add up to 0.9 are refused, and nodes off the chord.
pub(super) fn wrong_nodes(case: &RuleCase) -> LawResult {
    Ok(refused(case, LIGHT_WEIGHTS, laws::weights, "weights that add up to 0.9")?
        .and(refused(case, LIGHT_WEIGHTS, laws::constant_metrics, "weights that add up to 0.9")?)
        .and(refused(case, BEYOND, laws::nodes, "a node off the chord")?))
}

/// Checks that an exponent of 2 is refused for the left-endpoint rule.
pub(super) fn wrong_order(case: &RuleCase) -> LawResult {
    refused(case, WRONG_ORDER, laws::exponent, "an exponent of 2 for the left-endpoint rule")
}

/// Checks that an energy that differs from the sum over the nodes is refused.
pub(super) fn another_energy(case: &RuleCase) -> LawResult {
    let what = "an energy that is not that of the nodes";
    let law = |case: &RuleCase| {
        laws::gradient_of(case, |metric, sequence| 1.001 * case.rule.energy(metric, sequence))
    };
    refused(case, case.rule, law, what)
}

#[cfg(test)]
mod tests {
    use tautline::Rule;

    use super::{BEYOND, LIGHT_WEIGHTS, WRONG_ORDER, refused};
    use crate::{Effort, Fault, RuleCase, report::LawResult, rule::laws};

    fn case() -> RuleCase {
        RuleCase::new(Rule::TRAPEZOIDAL, Effort::default())
    }

    /// A law does not refuse a rule that satisfies it.
    #[test]
    fn an_accepted_mutant_is_a_fault() {
        let passes = |result: LawResult| {
            let fault = result.expect_err("it passes").fault;
            assert_eq!(fault, Fault::NotRefused { what: "it" });
        };
        passes(refused(&case(), Rule::TRAPEZOIDAL, laws::weights, "it"));
        passes(refused(&case(), BEYOND, laws::weights, "it"));
        passes(refused(&case(), LIGHT_WEIGHTS, laws::nodes, "it"));
        passes(refused(&case(), WRONG_ORDER, laws::gradient, "it"));
        passes(refused(&case(), Rule::TRAPEZOIDAL, laws::exponent, "it"));
    }

    #[test]
    fn a_refused_mutant_is_no_fault() {
        assert!(refused(&case(), LIGHT_WEIGHTS, laws::weights, "it").is_ok());
        assert!(refused(&case(), BEYOND, laws::nodes, "it").is_ok());
    }
}
