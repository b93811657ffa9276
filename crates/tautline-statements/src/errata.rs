//! The errata: what is false as printed, each with a counterexample and its two numbers.

use crate::{Finding, Inequality, Source, Statement, VerifyError};

/// A statement that is false as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Erratum {
    /// The statement; its verdict has the repair.
    pub statement: Statement,
    /// The smallest counterexample that we know, in words.
    pub witness: &'static str,
    /// The inequality of the printed form that it violates: observed above bound.
    pub violated: Inequality,
    /// Who relies on the statement, and whether it matters there.
    pub relied_on_by: &'static str,
}

/// Evaluates the counterexamples, and returns all errata in the paper's order.
///
/// # Errors
///
/// [`VerifyError::NotRefuted`] if a counterexample does not refute, which a correct build does not
/// return.
pub fn errata() -> Result<Vec<Erratum>, VerifyError> {
    let refuted = Statement::ALL.into_iter().filter_map(|statement| {
        let refutation = statement.refuted_by()?;
        Some((statement, refutation))
    });
    refuted
        .map(|(statement, refutation)| {
            // The repaired form needs that there is no kink; the printed form lacks this hypothesis.
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

    /// The statements whose verdict is that they are refuted, and no others.
    #[test]
    fn every_refuted_statement_has_its_erratum() {
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
