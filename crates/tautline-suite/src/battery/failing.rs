//! Evidence that has to fail: of statements that are false as printed, and without a hypothesis.

use tautline_statements::{Evidence, Finding, Inequality, Source};

use super::{Failure, Outcome, Tally};

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

/// Passes if these hypotheses, each named by a part of its claim, do not hold, all others hold, and
/// a stated conclusion fails: what a counterexample to the statement without them has to
/// show. More than one are named where one implies the other.
pub(super) fn fails_without(hypotheses: &[&str], evidence: Evidence) -> Outcome {
    let fails = stated(&evidence).any(is_false);
    dropped(hypotheses, &evidence, fails, "does not fail")
}

/// Passes if these hypotheses do not hold, all others hold, and so do all stated conclusions:
/// an example of what is proved where this is asked, that they are not needed.
pub(super) fn holds_without(hypotheses: &[&str], evidence: Evidence) -> Outcome {
    let holds = stated(&evidence).all(Inequality::holds);
    dropped(hypotheses, &evidence, holds, "does not hold")
}

fn stated(evidence: &Evidence) -> impl Iterator<Item = &Inequality> {
    evidence.conclusions.iter().filter(|claim| claim.source == Source::Stated)
}

/// Whether the numbers contradict the claim; NaN contradicts nothing.
fn is_false(claim: &Inequality) -> bool {
    claim.observed > claim.bound + claim.granted
}

fn dropped(hypotheses: &[&str], evidence: &Evidence, shown: bool, what: &str) -> Outcome {
    let alone = hypotheses.iter().all(|name| {
        let named = || evidence.hypotheses.iter().filter(|clause| clause.claim.contains(name));
        // A name that fits two clauses would not say which of them is dropped.
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
    use tautline_statements::{Evidence, Statement, Unit};

    use super::{fails_without, holds_without};

    /// `a`, and `b`, then `c`; each holds if its number is 0.
    fn evidence(a: f64, b: f64, c: f64) -> Evidence {
        Evidence::of(Statement::Lemma4_4)
            .given("a = 0", Unit::NONE, [a, 0.0], 0.0)
            .given("b = 0", Unit::NONE, [b, 0.0], 0.0)
            .stated("c = 0", Unit::NONE, [c, 0.0], 0.0)
            .sharper("c = 1", Unit::NONE, [1.0, c], 0.0)
    }

    #[test]
    fn just_the_named_hypotheses_fail() {
        assert!(fails_without(&["a"], evidence(1.0, 0.0, 1.0)).is_ok());
        assert!(fails_without(&["a"], evidence(1.0, 1.0, 1.0)).is_err());
        assert!(fails_without(&["a"], evidence(0.0, 0.0, 1.0)).is_err());
        assert!(fails_without(&["a", "b"], evidence(1.0, 1.0, 1.0)).is_ok());
        assert!(fails_without(&["a", "b"], evidence(1.0, 0.0, 1.0)).is_err());
        assert!(fails_without(&["another"], evidence(1.0, 0.0, 1.0)).is_err());
        // Both clauses contain this.
        assert!(fails_without(&["= 0"], evidence(1.0, 0.0, 1.0)).is_err());
    }

    #[test]
    fn a_conclusion_stated_decides_and_nan_does_not() {
        assert!(fails_without(&["a"], evidence(1.0, 0.0, 0.0)).is_err());
        assert!(holds_without(&["a"], evidence(1.0, 0.0, 0.0)).is_ok());
        assert!(holds_without(&["a"], evidence(1.0, 0.0, 1.0)).is_err());
        for outcome in [fails_without, holds_without] {
            assert!(outcome(&["a"], evidence(1.0, 0.0, f64::NAN)).is_err());
            assert!(outcome(&["a"], evidence(f64::NAN, 0.0, 1.0)).is_err());
            assert!(outcome(&["a"], evidence(1.0, f64::NAN, 1.0)).is_err());
        }
    }
}
