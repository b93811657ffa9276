//! `Check`: a named test that runs against the library or a mutant.

use tautline_statements::{PaperRule, Statement};

use super::{Failure, Outcome, Scope, Tally, Trial};

/// What a check shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A statement holds on random data.
    Random,
    /// In other units of coordinates and lengths, both sides scale by their unit.
    Homogeneous,
    /// A case comes near equality, or has the least overestimation known.
    Witness,
    /// Without one of its hypotheses a statement fails; or it still holds, and the hypothesis is
    /// not needed.
    Dropped,
    /// A statement is false as printed.
    Refuted,
    /// Errors fall with the predicted order, or with the predicted leading constant.
    Order,
    /// Numbers agree with reference values from another program.
    Reference,
    /// A statement holds for numbers proved with outward rounding.
    Proved,
}

impl Kind {
    /// Names a check of this kind.
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
    /// The name, which says what the check shows.
    pub name: &'static str,
    /// The kind of evidence.
    pub kind: Kind,
    /// The statements it is about.
    pub statements: &'static [Statement],
    run: fn(&Trial<'_>) -> Outcome,
}

impl Check {
    /// Runs the check on a trial's subject.
    ///
    /// # Errors
    ///
    /// [`Failure`](super::Failure) with the two numbers that show it.
    pub fn run(&self, trial: &Trial<'_>) -> Outcome {
        (self.run)(trial)
    }

    /// Runs the check; a failure begins with its name.
    pub(crate) fn run_by_name(&self, trial: &Trial<'_>) -> Outcome {
        self.run(trial).map_err(|failure| Failure::new(format!("{}: {failure}", self.name)))
    }

    /// Returns whether the check belongs to the suite of this scope. The paper's bounds alone only
    /// assert observed ≤ bound on random cases.
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

/// Runs a check for both rules, with each of these numbers of subintervals.
pub(crate) fn for_rules(
    subintervals: impl IntoIterator<Item = usize>,
    run: impl Fn(PaperRule, usize) -> Outcome,
) -> Outcome {
    let cases = subintervals.into_iter().flat_map(|n| PaperRule::BOTH.map(|rule| (rule, n)));
    all(cases.map(|(rule, n)| run(rule, n)))
}
