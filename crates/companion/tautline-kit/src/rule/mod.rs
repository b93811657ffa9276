//! The laws of a rule of numerical integration.
//!
//! There is one function per law, with the same name as its test in
//! [`rule_suite!`](crate::rule_suite).

mod laws;
mod mutants;

use tautline::Rule;

use super::{Effort, Report};

/// A rule to test, and the effort.
#[derive(Clone, Copy, Debug)]
pub struct RuleCase {
    rule: Rule,
    effort: Effort,
}

impl RuleCase {
    /// Returns the case of a rule, which is tested on metrics of the gallery.
    pub fn new(rule: Rule, effort: Effort) -> Self {
        Self { rule, effort }
    }
}

/// The laws, one per row: its name, its content, and the function that checks it.
#[doc(hidden)]
#[macro_export]
macro_rules! __rule_laws {
    ([$($callback:tt)*] $context:tt) => {
        $($callback)*! { $context
            weights_are_nonnegative_and_sum_to_1, "0 ≤ weights, Σ weights = 1",
                laws::weights;
            nodes_lie_on_the_chord, "0 ≤ fractions ≤ 1",
                laws::nodes;
            constant_metrics_are_integrated_exactly, "E_N = (1/N) Σ βᵀAβ for constant A",
                laws::constant_metrics;
            gradient_is_that_of_the_energy, "∇E_N is the limit of central differences",
                laws::gradient;
            error_exponent_is_observed, "E_N,min − d² falls like N⁻ᑫ on a shear",
                laws::exponent;
            refuses_wrong_nodes, "weights that add up to 0.9, and nodes off the chord, are refused",
                mutants::wrong_nodes;
            refuses_an_exponent_that_is_not_observed, "q = 2 for the left-endpoint rule is refused",
                mutants::wrong_order;
            refuses_an_energy_of_other_nodes, "1.001 E_N in place of E_N is refused",
                mutants::another_energy;
        }
    };
}

__rule_laws! {
    [super::laws::functions]
    { [] RuleCase, RuleCase::clone }
}

/// Checks all laws of a rule.
pub fn verify_rule(rule: Rule, effort: &Effort) -> Report {
    verify(&RuleCase::new(rule, *effort))
}
