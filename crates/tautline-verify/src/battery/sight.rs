//! `PaperAlone`: what the paper's bounds alone see of a mutant.

use super::{Check, Failure, Scope, Trial, fingerprint::Fingerprint, suite};
use crate::Mutant;

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

/// The paper's bounds on random cases, with the numbers that they compare for the library.
#[derive(Clone, Debug)]
pub struct PaperAlone {
    cases: u32,
    checks: Vec<(Check<Option<Mutant>>, Fingerprint)>,
}

impl PaperAlone {
    /// Puts the library to them, on at most so many random cases a family.
    ///
    /// # Errors
    ///
    /// The first check that the library itself fails.
    pub fn new(cases: u32) -> Result<Self, Failure> {
        let trial = Trial::new(&None, Scope::PaperAlone, cases);
        let mut checks = Vec::new();
        for check in suite().into_iter().filter(|check| check.is_in(trial.scope)) {
            checks.push((check, check.run(&trial)?.compared()));
        }
        Ok(Self { cases, checks })
    }

    /// Puts a mutant to them, on the same cases.
    ///
    /// Whether they could see it at all is read off the numbers, bit by bit.
    #[must_use]
    pub fn of(&self, mutant: Mutant) -> Sight {
        let subject = Some(mutant);
        let trial = Trial::new(&subject, Scope::PaperAlone, self.cases);
        let mut sight = Sight::Unseen;
        for (check, genuine) in &self.checks {
            match check.run(&trial) {
                Err(_) => return Sight::Killed,
                Ok(tally) if tally.compared() != *genuine => sight = Sight::Passes,
                Ok(_) => {}
            }
        }
        sight
    }
}

#[cfg(test)]
mod tests {
    use super::{PaperAlone, Sight};
    use crate::Mutant;

    /// Half an energy is too small; `K̄_{4,g}` may be too small by much before a bound fails; and no
    /// bound of the paper has Lemma S.3 or Proposition S.7 in it.
    #[test]
    fn a_mistake_is_killed_or_passes_or_is_not_seen_at_all() {
        let paper = PaperAlone::new(4).expect("the library passes");
        for (mutant, expected) in [
            (Mutant::EnergyHalved, Sight::Killed),
            (Mutant::K4IsK3, Sight::Passes),
            (Mutant::OmegaHalved, Sight::Unseen),
            (Mutant::StepHalved, Sight::Unseen),
            (Mutant::SlopeForgotten, Sight::Unseen),
        ] {
            assert_eq!(paper.of(mutant), expected, "{mutant:?}");
        }
    }
}
