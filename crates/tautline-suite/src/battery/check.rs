//! `Check`: a named test that runs against the library or a mutant.

use tautline_statements::Statement;

use super::{Outcome, Scope, Tally, Trial};

/// What a check shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A statement holds on random data.
    Random,
    /// Both sides scale by their unit where coordinates and lengths are measured in others.
    Homogeneous,
    /// A case comes near equality, or its overestimation is the best one known.
    Witness,
    /// Without one of its hypotheses a statement fails; or holds all the same, and the hypothesis
    /// is not needed.
    Dropped,
    /// A statement is false as printed.
    Refuted,
    /// Errors fall with the order, or with the leading constant, that theory predicts.
    Order,
    /// Numbers agree with reference values of another program.
    Reference,
    /// A statement holds for numbers that are proved, with outward rounding.
    Proved,
}

/// One named test.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// The name of the test, which says what it shows.
    pub name: &'static str,
    /// What it shows.
    pub kind: Kind,
    /// The statements that it is about.
    pub statements: &'static [Statement],
    run: fn(&Trial<'_>) -> Outcome,
}

impl Check {
    /// Names a test.
    pub const fn new(
        name: &'static str,
        kind: Kind,
        statements: &'static [Statement],
        run: fn(&Trial<'_>) -> Outcome,
    ) -> Self {
        Self { name, kind, statements, run }
    }

    /// Puts a subject to the test.
    ///
    /// # Errors
    ///
    /// [`Failure`](super::Failure) with the two numbers that show it.
    pub fn run(&self, trial: &Trial<'_>) -> Outcome {
        (self.run)(trial)
    }

    /// Returns whether the check belongs to the suite of this scope: that of the paper's bounds
    /// alone asserts observed ≤ bound on random cases, and no more.
    #[must_use]
    pub fn is_in(&self, scope: Scope) -> bool {
        let is_a_bound = self.statements.iter().any(|statement| statement.is_a_bound());
        scope == Scope::Everything || (self.kind == Kind::Random && is_a_bound)
    }
}

/// Merges the tallies of several runs; the first failure is the outcome.
pub(super) fn all(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
    let mut sum = Tally::default();
    for outcome in outcomes {
        sum.extend(&outcome?);
    }
    Ok(sum)
}
