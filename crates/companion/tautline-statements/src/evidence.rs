//! `Evidence`: one statement, evaluated on one case.

use crate::{Inequality, Source, Statement, Unit, VerifyError};

/// The hypotheses and conclusions of a statement, as numbers for one case.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// The statement.
    pub statement: Statement,
    /// The hypotheses that can be checked on the case.
    pub hypotheses: Vec<Inequality>,
    /// The hypotheses that the case cannot show.
    pub assumed: Vec<&'static str>,
    /// The claims of the statement, and sharper companions.
    pub conclusions: Vec<Inequality>,
}

/// The result of comparing the numbers of an [`Evidence`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finding<'a> {
    /// Hypotheses and conclusions hold.
    Holds,
    /// This hypothesis fails, so the statement does not apply to the case.
    Inapplicable(&'a Inequality),
    /// The hypotheses hold and this conclusion fails.
    Violated(&'a Inequality),
}

impl Evidence {
    /// Begins the evidence for a statement.
    #[must_use]
    pub fn of(statement: Statement) -> Self {
        Self { statement, hypotheses: Vec::new(), assumed: Vec::new(), conclusions: Vec::new() }
    }

    /// Adds a hypothesis `observed ≤ bound`.
    #[must_use]
    pub fn given(
        mut self,
        claim: &'static str,
        unit: Unit,
        [observed, bound]: [f64; 2],
        granted: f64,
    ) -> Self {
        let source = Source::Stated;
        self.hypotheses.push(Inequality { claim, source, unit, observed, bound, granted });
        self
    }

    /// Adds a hypothesis that either holds or fails, without numbers of its own.
    pub(crate) fn given_that(self, claim: &'static str, holds: bool) -> Self {
        let failures = if holds { 0.0 } else { 1.0 };
        self.given(claim, Unit::NONE, [failures, 0.0], 0.0)
    }

    /// Adds a hypothesis that no finite number of evaluations shows, for example that a minimiser
    /// is global.
    #[must_use]
    pub fn assumed(mut self, claim: &'static str) -> Self {
        if !self.assumed.contains(&claim) {
            self.assumed.push(claim);
        }
        self
    }

    /// Adds a conclusion `observed ≤ bound` of the statement, in its repaired form if it has one.
    #[must_use]
    pub fn stated(self, claim: &'static str, unit: Unit, numbers: [f64; 2], granted: f64) -> Self {
        self.concluded(Source::Stated, claim, unit, numbers, granted)
    }

    /// Adds a sharper companion `observed ≤ bound`.
    #[must_use]
    pub fn sharper(self, claim: &'static str, unit: Unit, numbers: [f64; 2], granted: f64) -> Self {
        self.concluded(Source::Sharper, claim, unit, numbers, granted)
    }

    /// Adds two inequalities which together claim that two ways to write one formula agree. They
    /// check the program and are [no evidence](Source::Identity) for the statement.
    #[must_use]
    pub fn identity(
        self,
        [claim, reverse]: [&'static str; 2],
        unit: Unit,
        [one, other]: [f64; 2],
        granted: f64,
    ) -> Self {
        let source = Source::Identity;
        let at_most = self.concluded(source, claim, unit, [one, other], granted);
        at_most.concluded(source, reverse, unit, [other, one], granted)
    }

    fn concluded(
        mut self,
        source: Source,
        claim: &'static str,
        unit: Unit,
        [observed, bound]: [f64; 2],
        granted: f64,
    ) -> Self {
        self.conclusions.push(Inequality { claim, source, unit, observed, bound, granted });
        self
    }

    /// Removes the hypothesis with this claim, for a statement whose printed form lacks it.
    #[must_use]
    pub fn without(mut self, claim: &str) -> Self {
        self.hypotheses.retain(|hypothesis| hypothesis.claim != claim);
        self
    }

    /// Compares the numbers. The conclusions count only where the hypotheses hold.
    #[must_use]
    pub fn finding(&self) -> Finding<'_> {
        if let Some(failed) = self.hypotheses.iter().find(|clause| !clause.holds()) {
            return Finding::Inapplicable(failed);
        }
        match self.conclusions.iter().find(|claim| !claim.holds()) {
            Some(failed) => Finding::Violated(failed),
            None => Finding::Holds,
        }
    }

    fn stated_conclusions(&self) -> impl Iterator<Item = &Inequality> {
        self.conclusions.iter().filter(|claim| claim.source == Source::Stated)
    }

    /// Returns whether the case could have contradicted the statement: one of the stated
    /// conclusions [could fail](Inequality::could_fail).
    #[must_use]
    pub fn could_fail(&self) -> bool {
        self.stated_conclusions().any(Inequality::could_fail)
    }

    /// Returns the least overestimation of the stated conclusions; `∞` if rounding hides them all.
    #[must_use]
    pub fn overestimation(&self) -> f64 {
        self.stated_conclusions().map(Inequality::overestimation).fold(f64::INFINITY, f64::min)
    }

    /// Returns the evidence if a stated conclusion is overestimated by at most 1 %, that is,
    /// attained.
    ///
    /// # Errors
    ///
    /// [`VerifyError::NotAttained`] with the least overestimation.
    pub fn attained(self) -> Result<Self, VerifyError> {
        self.overestimates_at_most(1.01)
    }

    /// Returns the evidence if the least overestimation of the stated conclusions is at most
    /// `known`. A loosened formula fails here.
    ///
    /// # Errors
    ///
    /// [`VerifyError::NotAttained`] with the least overestimation.
    pub fn overestimates_at_most(self, known: f64) -> Result<Self, VerifyError> {
        let overestimation = self.overestimation();
        self.at_most(overestimation, known)
    }

    /// Returns the evidence if the conclusion `claim` is overestimated by at most `known`.
    ///
    /// # Errors
    ///
    /// [`VerifyError::NotAttained`] with its overestimation.
    ///
    /// # Panics
    ///
    /// If no conclusion has this claim.
    #[track_caller]
    pub fn claim_is_attained(self, claim: &str, known: f64) -> Result<Self, VerifyError> {
        let overestimation = self.conclusion(claim).overestimation();
        self.at_most(overestimation, known)
    }

    fn at_most(self, overestimation: f64, known: f64) -> Result<Self, VerifyError> {
        if overestimation <= known {
            return Ok(self);
        }
        Err(VerifyError::NotAttained { statement: self.statement, overestimation, known })
    }

    /// Returns a conclusion by its claim.
    ///
    /// # Panics
    ///
    /// If no conclusion has this claim.
    #[must_use]
    #[track_caller]
    pub fn conclusion(&self, claim: &str) -> &Inequality {
        let found = self.conclusions.iter().find(|conclusion| conclusion.claim == claim);
        found.unwrap_or_else(|| panic!("{} does not claim {claim}", self.statement))
    }
}

/// Writes one line for each hypothesis and conclusion, with its numbers.
impl std::fmt::Display for Evidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.statement)?;
        self.hypotheses.iter().try_for_each(|clause| write!(f, "\n  given {clause}"))?;
        self.assumed.iter().try_for_each(|clause| write!(f, "\n  assumed: {clause}"))?;
        self.conclusions.iter().try_for_each(|claim| match claim.source {
            Source::Stated => write!(f, "\n  stated {claim}"),
            Source::Sharper => write!(f, "\n  sharper {claim}"),
            Source::Identity => write!(f, "\n  identity {claim}"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Evidence;
    use crate::{Finding, Statement, Unit};

    fn evidence() -> Evidence {
        Evidence::of(Statement::Theorem1_1)
            .given("a", Unit::NONE, [1.0, 2.0], 0.0)
            .assumed("b")
            .assumed("b")
            .stated("c", Unit::NONE, [1.0, 2.0], 0.0)
    }

    #[test]
    fn an_assumption_is_listed_once() {
        let shown = evidence().to_string();
        assert!(shown.contains("\n  given a: 1") && shown.contains("\n  stated c: 1"), "{shown}");
        assert_eq!(shown.matches("\n  assumed: b").count(), 1, "{shown}");
    }

    #[test]
    fn an_identity_can_fail_and_has_no_overestimation() {
        let equal = |one, other| {
            let begun = Evidence::of(Statement::Theorem1_1);
            begun.identity(["a ≤ b", "b ≤ a"], Unit::NONE, [one, other], 1e-9)
        };
        assert_eq!(equal(1.0, 1.0).finding(), Finding::Holds);
        assert_eq!(equal(1.0, 1.0).overestimation(), f64::INFINITY);
        assert!(!equal(1.0, 1.0).could_fail() && evidence().could_fail());
        for (one, other) in [(1.0, 1.1), (1.1, 1.0)] {
            assert!(matches!(equal(one, other).finding(), Finding::Violated(_)));
        }
    }
}
