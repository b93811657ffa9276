//! `Examination`: the suite as the library has passed it, and what it says of mutants.

use tautline_statements::{Asked, Bounds, Mutant, Subject};

use super::{Check, Failure, Scope, Trial, harness::Fingerprint, suite};

/// What the paper's bounds, observed ≤ bound on random cases and nothing else, say of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// Every number that they compare is the library's, to the last bit: they say nothing of it.
    Unseen,
    /// They compare other numbers, and all of them hold.
    Passes,
    /// One of them is violated.
    Killed,
}

/// The suite of a scope, with what each check asked the library for.
///
/// A check computes the same for a mutant unless it asks for what is wrong with it: only those that do are
/// run.
#[derive(Clone, Debug)]
pub struct Examination {
    scope: Scope,
    cases: u32,
    checks: Vec<Passed>,
}

/// A check that the library has passed.
#[derive(Clone, Copy, Debug)]
struct Passed {
    check: Check,
    asked: Asked,
    compared: Fingerprint,
}

impl Examination {
    /// Puts the library to the suite, on at most so many random cases a family.
    ///
    /// # Errors
    ///
    /// The first check that the library itself fails.
    pub fn new(scope: Scope, cases: u32) -> Result<Self, Failure> {
        let library = Subject::with(Bounds::LIBRARY);
        let trial = Trial::new(&library, scope, cases);
        let mut checks = Vec::new();
        for check in suite().into_iter().filter(|check| check.is_in(scope)) {
            let tally = check
                .run(&trial)
                .map_err(|failure| Failure::new(format!("{}: {failure}", check.name)))?;
            checks.push(Passed { check, asked: library.take_asked(), compared: tally.compared() });
        }
        Ok(Self { scope, cases, checks })
    }

    /// Returns the names of the first checks that a mutant fails on the same cases, in the suite's order.
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

    /// Returns whether a mutant is seen and killed on the same cases.
    ///
    /// Whether a check sees it at all is read off the numbers, bit by bit.
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

    /// Returns the checks that ask for what is wrong with a mutant.
    pub fn asking_for(&self, mutant: Mutant) -> impl Iterator<Item = &Check> {
        self.that_see(&Subject::from(mutant)).map(|passed| &passed.check)
    }

    fn that_see(&self, subject: &Subject) -> impl Iterator<Item = &Passed> + use<'_> {
        let replaced = subject.replaced();
        self.checks.iter().filter(move |passed| passed.asked.meets(replaced))
    }
}
