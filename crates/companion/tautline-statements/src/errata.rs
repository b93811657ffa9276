//! The errata: statements that are false as printed, each with a counterexample in numbers.

use crate::{Finding, Inequality, Source, Statement, VerifyError};

/// A statement that is false as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Erratum {
    /// The statement; its verdict states the repair.
    pub statement: Statement,
    /// The smallest known counterexample, in words.
    pub witness: &'static str,
    /// The inequality of the printed form that it violates.
    pub violated: Inequality,
    /// Which statements rely on it, and whether the error matters there.
    pub relied_on_by: &'static str,
}

/// Evaluates the counterexamples and returns all errata, in the paper's order.
///
/// # Errors
///
/// [`VerifyError::NotRefuted`] if a counterexample does not refute its statement, which never
/// happens in a correct build.
pub fn errata() -> Result<Vec<Erratum>, VerifyError> {
    Statement::ALL
        .into_iter()
        .filter_map(|statement| Some((statement, statement.refuted_by()?)))
        .map(|(statement, refutation)| {
            // The repaired form excludes kinks; the printed form lacks this hypothesis.
            let evidence = (refutation.evidence)()?.without("γ̇ does not jump");
            match evidence.finding() {
                Finding::Violated(&violated)
                    if violated.source == Source::Stated && evidence.statement == statement =>
                {
                    let (witness, relied_on_by) = (refutation.witness, refutation.relied_on_by);
                    Ok(Erratum { statement, witness, violated, relied_on_by })
                }
                _ => Err(VerifyError::NotRefuted { statement }),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::errata;
    use crate::{Statement, Verdict};

    #[test]
    fn the_refuted_statements_and_no_others_have_errata() {
        let refuted =
            |statement: &Statement| matches!(statement.verdict(), Verdict::RefutedRepairedAs(_));
        let statements: Vec<Statement> = Statement::ALL.into_iter().filter(refuted).collect();
        let errata = errata().expect("every witness refutes");
        assert!(errata.iter().map(|erratum| erratum.statement).eq(statements));
        for erratum in errata {
            assert!(!erratum.violated.holds(), "{}", erratum.violated);
        }
    }
}
