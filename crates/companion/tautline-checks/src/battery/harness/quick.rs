//! Random cases that are drawn and shrunk by quickcheck.

use std::fmt::Debug;

use quickcheck::{Arbitrary, Gen};
use tautline_statements::{Evidence, Subject, VerifyError};

use super::{Case, Failure, Outcome, Tally, Trial};

/// The maximal number of shrinking steps; each step moves to the first smaller case that still
/// fails.
const MAX_SHRINKS: usize = 1000;

impl Trial<'_> {
    /// Evaluates statements on `cases` values of an [`Arbitrary`] type, in the same way as
    /// [`for_all`](Trial::for_all).
    ///
    /// # Errors
    ///
    /// The first evidence that fails, on the smallest failing case that quickcheck finds.
    pub fn quick<A, E>(
        &self,
        seed: u64,
        cases: u32,
        evidence: impl Fn(&Subject, &A) -> Result<E, VerifyError>,
    ) -> Outcome
    where
        A: Arbitrary + Debug,
        E: IntoIterator<Item = Evidence>,
    {
        let run = |value: &A| self.one(evidence(self.subject, value)?);
        if let Some(given) = self.given {
            return given.take(seed).map_or(Ok(Tally::default()), |value| run(&value));
        }
        let mut source = Gen::from_size_and_seed(24, self.chance.seed(seed));
        let mut tally = Tally::default();
        for _ in 0..self.chance.cases(cases).min(self.cases) {
            let mut value = A::arbitrary(&mut source);
            match run(&value) {
                Ok(count) => tally.extend(&count),
                Err(mut failure) => {
                    for _ in 0..MAX_SHRINKS {
                        let smaller =
                            value.shrink().find_map(|value| Some((run(&value).err()?, value)));
                        let Some(found) = smaller else { break };
                        (failure, value) = found;
                    }
                    let message = format!("seed {seed}: {failure}, for {value:?}");
                    return Err(Failure { message, case: Some(Case::new(seed, &value)) });
                }
            }
        }
        Ok(tally)
    }
}

#[cfg(test)]
mod tests {
    use tautline_statements::{Evidence, LIBRARY, Statement, Unit};

    use crate::{
        arbitrary::Nonnegatives,
        battery::{Scope, Trial},
    };

    /// The claim "No number is above 100" shrinks to one number just above 100.
    #[test]
    fn a_false_claim_is_shrunk_to_its_smallest_case() {
        let trial = Trial::new(&LIBRARY, Scope::Everything, u32::MAX);
        let outcome = trial.quick(1, 100, |_, numbers: &Nonnegatives| {
            let largest = numbers.numbers().into_iter().fold(0.0, f64::max);
            let evidence = Evidence::of(Statement::Proposition7_8);
            Ok([evidence.stated("x ≤ 100", Unit::COORDINATE, [largest, 100.0], 0.0)])
        });
        let message = outcome.expect_err("false").message;
        // 1601/16 is the first multiple of 1/16 above 100.
        assert!(message.ends_with("Nonnegatives([1601])"), "{message}");
    }
}
