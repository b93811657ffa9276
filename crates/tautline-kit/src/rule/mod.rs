//! The laws of a rule of numerical integration.
//!
//! One function a law, of the name that its test has in [`rule_suite!`](crate::rule_suite).

mod laws;
mod liar;

use tautline::Rule;

use super::{Effort, Outcome, Report};

/// A rule, and for how long to look.
#[derive(Clone, Copy, Debug)]
pub struct RuleCase<R> {
    rule: R,
    effort: Effort,
}

impl<R: Rule> RuleCase<R> {
    /// A rule to be tried on metrics of the gallery.
    pub fn new(rule: R, effort: Effort) -> Self {
        Self { rule, effort }
    }
}

/// The laws, one a row: its name, what it says, and the function that tries it.
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
                liar::wrong_nodes;
            refuses_an_exponent_that_is_not_observed, "q = 2 for the left-endpoint rule is refused",
                liar::boast;
            refuses_an_energy_of_other_nodes, "1.001 E_N in place of E_N is refused",
                liar::another_energy;
        }
    };
}

/// One function a law, their names, and all of them in a row.
macro_rules! functions {
    ({} $($id:ident, $law:literal, $run:expr;)*) => {
        $(
            #[doc = concat!("Tries the law `", stringify!($id), "`: `", $law, "`.")]
            pub fn $id<R: Rule>(case: &RuleCase<R>) -> Outcome {
                let run: fn(&RuleCase<R>) -> super::report::LawResult = $run;
                Outcome::new(stringify!($id), $law, run(case))
            }
        )*

        /// The names of all laws, in the order of a report.
        pub const LAWS: &[&str] = &[$(stringify!($id)),*];

        /// Tries all laws on a rule.
        pub fn verify_rule<R: Rule>(rule: R, effort: &Effort) -> Report {
            let case = RuleCase::new(rule, *effort);
            Report { outcomes: vec![$($id(&case)),*] }
        }
    };
}

__rule_laws! { [functions] {} }
