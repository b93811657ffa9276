//! Verdicts on evidence that must fail: on statements that are false as printed, or that lack a
//! hypothesis.

use tautline_statements::{Evidence, Finding, Inequality, Source};

use super::{Failure, Outcome, Tally};

/// Passes if the hypotheses hold and the conclusion `claim` fails with these numbers (observed and
/// bound), to a relative `10⁻¹⁰`. The tolerance is needed because `K₁` and `K₂` are rounded up by
/// the errors of their quadratures.
pub(crate) fn refuted(evidence: &Evidence, claim: &str, numbers: [f64; 2]) -> Outcome {
    let (statement, finding) = (evidence.statement, evidence.finding());
    let Finding::Violated(failed) = finding else {
        return Err(Failure::new(format!("{statement} is not refuted: {finding:?}")));
    };
    let found = [failed.observed, failed.bound];
    let near =
        |(found, number): (f64, f64)| (found - number).abs() <= 1e-10 * number.abs().max(1.0);
    if failed.claim == claim && found.into_iter().zip(numbers).all(near) {
        return Ok(Tally::default());
    }
    Err(Failure::new(format!("{statement}: {failed}, not {claim} with {numbers:?}")))
}

/// Passes if a stated conclusion fails and exactly the named hypotheses fail, which is what a
/// counterexample has to show. A hypothesis is named by a part of its claim. Several are named if
/// one implies another.
pub(crate) fn fails_without(hypotheses: &[&str], evidence: Evidence) -> Outcome {
    let fails = stated(&evidence).any(is_false);
    dropped(hypotheses, &evidence, fails, "does not fail")
}

/// Passes if exactly the named hypotheses fail and all stated conclusions hold. This is an example
/// for the proof, given at the call, that the hypotheses are not needed.
pub(crate) fn holds_without(hypotheses: &[&str], evidence: Evidence) -> Outcome {
    let holds = stated(&evidence).all(Inequality::holds);
    dropped(hypotheses, &evidence, holds, "does not hold")
}

fn stated(evidence: &Evidence) -> impl Iterator<Item = &Inequality> {
    evidence.conclusions.iter().filter(|claim| claim.source == Source::Stated)
}

/// Returns whether the numbers contradict the claim; NaN contradicts nothing.
fn is_false(claim: &Inequality) -> bool {
    claim.observed > claim.bound + claim.granted
}

fn dropped(hypotheses: &[&str], evidence: &Evidence, shown: bool, what: &str) -> Outcome {
    let alone = hypotheses.iter().all(|name| {
        let named = || evidence.hypotheses.iter().filter(|clause| clause.claim.contains(name));
        // A name that fits two clauses does not determine which of them is dropped.
        let one = named().all(|clause| Some(clause.claim) == named().next().map(|one| one.claim));
        one && named().any(is_false)
    });
    let mut others = evidence
        .hypotheses
        .iter()
        .filter(|clause| !hypotheses.iter().any(|name| clause.claim.contains(name)));
    if alone && others.all(Inequality::holds) && shown {
        return Ok(Tally::default());
    }
    let statement = evidence.statement;
    Err(Failure::new(format!("{statement} {what} without {hypotheses:?} alone: {evidence:?}")))
}

#[cfg(test)]
mod tests {
    use tautline_statements::Evidence;

    use super::{super::sample, fails_without, holds_without};

    /// Returns evidence with two hypotheses and a stated conclusion, which hold at 0 and fail at 2.
    /// The companion holds where the conclusion fails.
    fn evidence(a: f64, b: f64, stated: f64) -> Evidence {
        sample([a, b], stated, 2.0 - stated)
    }

    #[test]
    fn exactly_the_named_hypotheses_fail() {
        assert!(fails_without(&["a"], evidence(2.0, 0.0, 2.0)).is_ok());
        assert!(fails_without(&["a"], evidence(2.0, 2.0, 2.0)).is_err());
        assert!(fails_without(&["a"], evidence(0.0, 0.0, 2.0)).is_err());
        assert!(fails_without(&["a", "b"], evidence(2.0, 2.0, 2.0)).is_ok());
        assert!(fails_without(&["a", "b"], evidence(2.0, 0.0, 2.0)).is_err());
        assert!(fails_without(&["another"], evidence(2.0, 0.0, 2.0)).is_err());
        // The claims of both clauses contain this text.
        assert!(fails_without(&["≤ 1"], evidence(2.0, 0.0, 2.0)).is_err());
    }

    #[test]
    fn the_stated_conclusion_decides_and_nan_does_not() {
        assert!(fails_without(&["a"], evidence(2.0, 0.0, 0.0)).is_err());
        assert!(holds_without(&["a"], evidence(2.0, 0.0, 0.0)).is_ok());
        assert!(holds_without(&["a"], evidence(2.0, 0.0, 2.0)).is_err());
        for outcome in [fails_without, holds_without] {
            assert!(outcome(&["a"], evidence(2.0, 0.0, f64::NAN)).is_err());
            assert!(outcome(&["a"], evidence(f64::NAN, 0.0, 2.0)).is_err());
            assert!(outcome(&["a"], evidence(2.0, f64::NAN, 2.0)).is_err());
        }
    }
}
