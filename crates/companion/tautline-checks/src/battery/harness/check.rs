//! `Check`: a named test that runs against the library or a mutant.

use tautline_statements::{PaperRule, Statement};

use super::{Failure, Outcome, Scope, Tally, Trial};

/// What a check shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A statement holds on random data.
    Random,
    /// In other units of coordinates and lengths, both sides of an inequality scale by their unit.
    Homogeneous,
    /// A case comes close to equality, or has the smallest overestimation known.
    Witness,
    /// A statement fails without one of its hypotheses; or it still holds, which shows that the
    /// hypothesis is not needed.
    Dropped,
    /// A statement is false as printed.
    Refuted,
    /// Errors decrease with the predicted order or have the predicted leading constant.
    Order,
    /// Numbers agree with reference values from another program.
    Reference,
    /// A statement holds for numbers that are proved with outward rounding.
    Proved,
}

impl Kind {
    /// Makes a check of this kind with a name.
    pub(crate) const fn check(
        self,
        name: &'static str,
        statements: &'static [Statement],
        run: fn(&Trial<'_>) -> Outcome,
    ) -> Check {
        Check { name, kind: self, statements, run }
    }
}

/// One named test.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// The name, which states what the check shows.
    pub name: &'static str,
    /// The kind of evidence that it gives.
    pub kind: Kind,
    /// The statements that it is about.
    pub statements: &'static [Statement],
    run: fn(&Trial<'_>) -> Outcome,
}

impl Check {
    /// Runs the check on a trial's subject.
    ///
    /// # Errors
    ///
    /// [`Failure`](super::Failure) with the two numbers that violate a claim.
    pub fn run(&self, trial: &Trial<'_>) -> Outcome {
        (self.run)(trial)
    }

    /// Runs the check; the message of a failure begins with the name of the check.
    pub(crate) fn run_by_name(&self, trial: &Trial<'_>) -> Outcome {
        self.run(trial).map_err(|failure| Failure::new(format!("{}: {failure}", self.name)))
    }

    /// Returns whether the check belongs to the suite of this scope. With the paper's bounds alone,
    /// only checks on random cases belong to it, and these only assert observed ≤ bound.
    #[must_use]
    pub fn is_in(&self, scope: Scope) -> bool {
        let is_a_bound = self.statements.iter().any(|statement| statement.is_a_bound());
        scope == Scope::Everything || (self.kind == Kind::Random && is_a_bound)
    }
}

/// Merges the tallies of several runs, or returns the first failure.
pub(crate) fn all(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
    let mut sum = Tally::default();
    for outcome in outcomes {
        sum.extend(&outcome?);
    }
    Ok(sum)
}

/// Runs a check for both rules, each with all of these numbers of subintervals.
pub(crate) fn for_rules(
    subintervals: impl IntoIterator<Item = usize>,
    run: impl Fn(PaperRule, usize) -> Outcome,
) -> Outcome {
    let cases = subintervals.into_iter().flat_map(|n| PaperRule::BOTH.map(|rule| (rule, n)));
    all(cases.map(|(rule, n)| run(rule, n)))
}
