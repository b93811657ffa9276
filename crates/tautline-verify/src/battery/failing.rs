//! Evidence that has to fail: of statements that are false as printed, and without a hypothesis.

use super::{Failure, Outcome};
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

/// Passes if the hypothesis `clause` is the first that does not hold, and a conclusion fails.
pub(super) fn dropped(evidence: &Evidence, clause: &str) -> Outcome {
    let lies = matches!(evidence.finding(), Finding::Inapplicable(lie) if lie.claim == clause);
    let fails = evidence.conclusions.iter().any(|conclusion| !conclusion.holds());
    if lies && fails {
        Ok(Default::default())
    } else {
        Err(Failure::new(format!("{} survives without {clause}: {evidence:?}", evidence.statement)))
    }
}
