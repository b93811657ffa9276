//! `Examination`: runs the suite, as the library passes it, on mutants.

use tautline_statements::{Asked, Bounds, Mutant, Subject};

use super::{Check, Failure, Scope, Trial, harness::Fingerprint, suite};

/// What the paper's bounds alone, observed ≤ bound on random cases, reveal about a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// Every number that the bounds compare is the library's number, bit for bit.
    Unseen,
    /// The bounds compare other numbers, and all of the bounds hold.
    Passes,
    /// One of the bounds is violated.
    Killed,
}

/// The suite of a scope, with the functions of the library that each check called.
///
/// A check computes the same numbers for a mutant unless it calls a function that the mutant
/// replaces, so only checks that do so are run.
#[derive(Clone, Debug)]
pub struct Examination {
    scope: Scope,
    cases: u32,
    checks: Vec<Passed>,
}

/// A check that the library passed.
#[derive(Clone, Copy, Debug)]
struct Passed {
    check: Check,
    asked: Asked,
    compared: Fingerprint,
}

impl Examination {
    /// Runs the suite on the library, with at most `cases` random cases per family.
    ///
    /// # Errors
    ///
    /// The failure of the first check that the library itself does not pass.
    pub fn new(scope: Scope, cases: u32) -> Result<Self, Failure> {
        let library = Subject::with(Bounds::LIBRARY);
        let trial = Trial::new(&library, scope, cases);
        let mut checks = Vec::new();
        for check in suite().into_iter().filter(|check| check.is_in(scope)) {
            let tally = check.run_by_name(&trial)?;
            checks.push(Passed { check, asked: library.take_asked(), compared: tally.compared() });
        }
        Ok(Self { scope, cases, checks })
    }

    /// Returns the names of the first `most` checks, in the suite's order, that a mutant fails on
    /// the same cases.
    #[must_use]
    pub fn kills(&self, mutant: Mutant, most: usize) -> Vec<&'static str> {
        let subject = Subject::from(mutant);
        let trial = Trial::new(&subject, self.scope, self.cases);
        let failing = |check: &&Check| check.run(&trial).is_err();
        self.that_see(&subject)
            .map(|passed| &passed.check)
            .filter(failing)
            .map(|check| check.name)
            .take(most)
            .collect()
    }

    /// Returns whether the checks compute different numbers for a mutant on the same cases, bit for
    /// bit, and whether they kill it.
    #[must_use]
    pub fn sight(&self, mutant: Mutant) -> Sight {
        let subject = Subject::from(mutant);
        let trial = Trial::new(&subject, self.scope, self.cases);
        let mut sight = Sight::Unseen;
        for passed in self.that_see(&subject) {
            match passed.check.run(&trial) {
                Err(_) => return Sight::Killed,
                Ok(tally) if tally.compared() != passed.compared => sight = Sight::Passes,
                Ok(_) => {}
            }
        }
        sight
    }

    /// Returns the checks that call a function that a mutant replaces.
    pub fn asking_for(&self, mutant: Mutant) -> impl Iterator<Item = &Check> {
        self.that_see(&Subject::from(mutant)).map(|passed| &passed.check)
    }

    fn that_see(&self, subject: &Subject) -> impl Iterator<Item = &Passed> + use<'_> {
        let replaced = subject.replaced();
        self.checks.iter().filter(move |passed| passed.asked.meets(replaced))
    }
}
