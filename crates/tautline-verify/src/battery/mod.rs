//! The project's own suite: named checks, to which the library and any variant of it can be put.
//!
//! A check is generic over its [`Subject`]. The tests of the workspace run all of them on
//! [`Library`](crate::Library); the table of mutants runs them on deliberately wrong variants, and
//! shows which check kills which.

mod admissible;
mod check;
mod close;
mod dropped;
mod existence;
mod failing;
mod fingerprint;
mod global_minima;
mod golden;
mod gradients;
mod leading_constants;
mod ledger;
mod orders;
mod point_sequences;
mod promotion;
mod proved_numbers;
mod quick;
mod random_problems;
mod section_1;
mod section_3;
mod section_4;
mod section_5;
mod section_6;
mod section_7_algebra;
mod section_7_apriori;
mod section_7_morrey;
mod section_7_sampling;
mod section_9;
mod sharper;
mod sheared;
mod sight;
mod slope;
mod tally;
mod theorem_witnesses;
mod trial;

pub use check::{Check, Kind};
pub use ledger::{Entry, kills, ledger, suite};
pub use promotion::{Case, Given};
pub use sight::{PaperAlone, Sight};
pub use tally::{Count, Tally};
pub use trial::{Failure, Outcome, Scope, Trial};

use crate::Subject;

/// Returns all checks, in the paper's order.
#[must_use]
pub fn battery<S: Subject>() -> Vec<Check<S>> {
    let sections = [
        section_1::checks(),
        theorem_witnesses::checks(),
        orders::checks(),
        leading_constants::checks(),
        golden::checks(),
        gradients::checks(),
        section_3::checks(),
        section_4::checks(),
        section_5::checks(),
        global_minima::checks(),
        section_6::checks(),
        existence::checks(),
        section_7_morrey::checks(),
        section_7_algebra::checks(),
        section_7_sampling::checks(),
        section_7_apriori::checks(),
        point_sequences::checks(),
        proved_numbers::checks(),
        section_9::checks(),
        dropped::checks(),
        sharper::checks(),
    ];
    sections.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::{Check, Kind, battery};
    use crate::{Library, Statement, Verdict};

    /// The statements without a check in which a hypothesis is dropped, and why there is none.
    const NOTHING_TO_DROP: [(Statement, &str); 5] = [
        (Statement::Proposition7_2, "any piecewise smooth curve will do: there is no hypothesis"),
        (Statement::Proposition7_4, "the only one is the repair: prop_7_4_refuted_by_a_kink"),
        (Statement::ConstantCTra, "a definition: there is no hypothesis"),
        (Statement::ConstantCTraSharp, "it compares two formulas: there is no hypothesis"),
        (Statement::Proposition7_8, "not needed: prop_7_8_holds_for_negative_numbers_too"),
    ];

    fn has(statement: Statement, kind: Kind) -> bool {
        let checks: Vec<Check<Library>> = battery();
        checks.iter().any(|check| check.kind == kind && check.statements.contains(&statement))
    }

    #[test]
    fn every_statement_is_asked_at_random_in_units_at_equality_and_without_hypotheses() {
        for statement in Statement::ALL {
            for kind in [Kind::Random, Kind::Homogeneous, Kind::Witness] {
                assert!(has(statement, kind), "{statement} has no check of kind {kind:?}");
            }
            let excepted = NOTHING_TO_DROP.iter().any(|(exception, _)| *exception == statement);
            let dropped = has(statement, Kind::Dropped);
            assert!(dropped != excepted, "{statement}: dropped {dropped}, excepted {excepted}");
        }
    }

    /// What is false as printed, or holds in one of two readings only.
    #[test]
    fn just_what_is_false_as_printed_or_as_read_is_refuted() {
        for statement in Statement::ALL {
            let verdict = statement.verdict();
            let refuted =
                matches!(verdict, Verdict::RefutedRepairedAs(_) | Verdict::HoldsReadAs(_));
            assert_eq!(has(statement, Kind::Refuted), refuted, "{statement}: {verdict:?}");
        }
    }
}
