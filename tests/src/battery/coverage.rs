//! Checks that every statement is tested in each of the required ways.

use tautline_checks::battery::{Kind, suite};
use tautline_statements::{Statement, Verdict};

/// The statements for which no check drops a hypothesis, and the reason.
const NOTHING_TO_DROP: [(Statement, &str); 5] = [
    (Statement::Proposition7_2, "any piecewise smooth curve will do: there is no hypothesis"),
    (Statement::Proposition7_4, "the only one is the repair: prop_7_4_refuted_by_a_kink"),
    (Statement::ConstantCTra, "a definition: there is no hypothesis"),
    (Statement::ConstantCTraSharp, "it compares two formulas: there is no hypothesis"),
    (Statement::Proposition7_8, "not needed: prop_7_8_holds_for_negative_numbers_too"),
];

fn has(statement: Statement, kind: Kind) -> bool {
    suite().iter().any(|check| check.kind == kind && check.statements.contains(&statement))
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

/// A statement is refuted if it is false as printed, or if it holds in only one of two readings.
#[test]
fn just_what_is_false_as_printed_or_as_read_is_refuted() {
    for statement in Statement::ALL {
        let verdict = statement.verdict();
        let refuted = matches!(verdict, Verdict::RefutedRepairedAs(_) | Verdict::HoldsReadAs(_));
        assert_eq!(has(statement, Kind::Refuted), refuted, "{statement}: {verdict:?}");
    }
}
