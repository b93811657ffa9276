//! Evidence that has to fail: of statements that are false as printed, and without a hypothesis.

use super::{Failure, Outcome, Tally};
use crate::{Evidence, Finding};

/// Passes if the hypotheses hold and the conclusion `claim` fails with just these numbers,
/// observed and bound, up to `10⁻¹⁰` of them (`K₁` and `K₂` are rounded up by the errors of their
/// quadratures).
pub(super) fn refuted(evidence: &Evidence, claim: &str, numbers: [f64; 2]) -> Outcome {
    let Finding::Violated(failed) = evidence.finding() else {
        return Err(Failure::new(format!(
            "{} is not refuted: {:?}",
            evidence.statement,
            evidence.finding()
        )));
    };
    let found = [failed.observed, failed.bound];
    let near =
        |(found, number): (f64, f64)| (found - number).abs() <= 1e-10 * number.abs().max(1.0);
    if failed.claim == claim && found.into_iter().zip(numbers).all(near) {
        Ok(Default::default())
    } else {
        Err(Failure::new(format!(
            "{}: {failed}, where {claim} with {numbers:?}",
            evidence.statement
        )))
    }
}

/// Returns the evidence without the hypothesis `clause`: as the paper prints it.
pub(super) fn without(mut evidence: Evidence, clause: &str) -> Evidence {
    evidence.hypotheses.retain(|hypothesis| hypothesis.claim != clause);
    evidence
}

/// Passes if a hypothesis, named by a part of its claim, is the only one that does not hold, and a
/// conclusion fails: what a counterexample to the statement without that hypothesis has to show.
pub(super) fn fails_without(hypothesis: &str, evidence: Evidence) -> Outcome {
    let lies = matches!(evidence.finding(), Finding::Inapplicable(clause)
        if clause.claim.contains(hypothesis));
    let others = evidence.hypotheses.iter().filter(|clause| !clause.claim.contains(hypothesis));
    let alone = others.clone().all(|clause| clause.holds());
    let fails = evidence.conclusions.iter().any(|claim| !claim.holds());
    if lies && alone && fails {
        return Ok(Tally::default());
    }
    let statement = evidence.statement;
    Err(Failure::new(format!("{statement} does not fail without {hypothesis} alone: {evidence:?}")))
}
