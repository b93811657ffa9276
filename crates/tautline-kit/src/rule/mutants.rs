//! Wrong rules, which the laws must refuse.

use tautline::{LeftEndpoint, Metric, Node, PointSequence, Rule};

use super::{RuleCase, laws};
use crate::{
    Fault,
    report::{LawResult, Tried},
};

/// The left-endpoint rule with a claimed exponent of 2.
#[derive(Clone, Copy, Debug)]
struct WrongOrder;

impl Rule for WrongOrder {
    const NODES: &'static [Node] = LeftEndpoint::NODES;
    const ERROR_EXPONENT: i32 = 2;
}

/// A rule with weights that add up to 0.9.
#[derive(Clone, Copy, Debug)]
struct LightWeights;

impl Rule for LightWeights {
    const NODES: &'static [Node] = &[Node { fraction: 0.5, weight: 0.9 }];
    const ERROR_EXPONENT: i32 = 2;
}

/// A rule with a node beyond the end of the chord.
#[derive(Clone, Copy, Debug)]
struct Beyond;

impl Rule for Beyond {
    const NODES: &'static [Node] =
        &[Node { fraction: -0.5, weight: 0.5 }, Node { fraction: 1.5, weight: 0.5 }];
    const ERROR_EXPONENT: i32 = 2;
}

/// A rule with an energy that differs from the sum over its nodes.
#[derive(Clone, Copy, Debug)]
struct OtherEnergy<R>(R);

impl<R: Rule> Rule for OtherEnergy<R> {
    const NODES: &'static [Node] = R::NODES;
    const ERROR_EXPONENT: i32 = R::ERROR_EXPONENT;

    fn energy<const D: usize>(&self, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> f64 {
        1.001 * self.0.energy(metric, sequence)
    }
}

/// Fails if a law accepts a rule that violates it.
fn refused<R: Rule, W: Rule>(
    case: &RuleCase<R>,
    wrong: W,
    law: fn(&RuleCase<W>) -> LawResult,
    what: &'static str,
) -> LawResult {
    match law(&RuleCase { rule: wrong, effort: case.effort }) {
        Err(_) => Ok(Tried::cases(1)),
        Ok(_) => Err(case.effort.failure(Fault::NotRefused { what })),
    }
}

/// Checks that weights that add up to 0.9 are refused, and nodes off the chord.
pub(super) fn wrong_nodes<R: Rule>(case: &RuleCase<R>) -> LawResult {
    Ok(refused(case, LightWeights, laws::weights, "weights that add up to 0.9")?
        .and(refused(case, LightWeights, laws::constant_metrics, "weights that add up to 0.9")?)
        .and(refused(case, Beyond, laws::nodes, "a node off the chord")?))
}

/// Checks that an exponent of 2 is refused for the left-endpoint rule.
pub(super) fn wrong_order<R: Rule>(case: &RuleCase<R>) -> LawResult {
    refused(case, WrongOrder, laws::exponent, "an exponent of 2 for the left-endpoint rule")
}

/// Checks that the rule itself is refused with an energy that differs from the sum over its nodes.
pub(super) fn another_energy<R: Rule>(case: &RuleCase<R>) -> LawResult {
    let what = "an energy that is not that of the nodes";
    refused(case, OtherEnergy(case.rule), laws::gradient, what)
}

#[cfg(test)]
mod tests {
    use tautline::Trapezoidal;

    use super::{Beyond, LightWeights, WrongOrder, refused};
    use crate::{Effort, Fault, RuleCase, report::LawResult, rule::laws};

    fn case() -> RuleCase<Trapezoidal> {
        RuleCase::new(Trapezoidal, Effort::default())
    }

    /// A law does not refuse a rule that satisfies it.
    #[test]
    fn an_accepted_mutant_is_a_fault() {
        let passes = |result: LawResult| {
            let fault = result.expect_err("it passes").fault;
            assert_eq!(fault, Fault::NotRefused { what: "it" });
        };
        passes(refused(&case(), Trapezoidal, laws::weights, "it"));
        passes(refused(&case(), Beyond, laws::weights, "it"));
        passes(refused(&case(), LightWeights, laws::nodes, "it"));
        passes(refused(&case(), WrongOrder, laws::gradient, "it"));
        passes(refused(&case(), Trapezoidal, laws::exponent, "it"));
    }

    #[test]
    fn a_refused_mutant_is_no_fault() {
        assert!(refused(&case(), LightWeights, laws::weights, "it").is_ok());
        assert!(refused(&case(), Beyond, laws::nodes, "it").is_ok());
    }
}
