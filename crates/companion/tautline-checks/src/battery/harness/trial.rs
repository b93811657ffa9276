//! `Trial`: one run of a check on a subject.

use std::{any::Any, cell::RefCell, fmt::Debug};

use proptest::{
    prelude::{BoxedStrategy, Strategy},
    test_runner::{Config, TestCaseError, TestError, TestRunner},
};
use tautline_chance::Chance;
use tautline_statements::{Evidence, Finding, Source, Subject, VerifyError};

use super::{
    Case, Failure, Given, Outcome, Tally,
    any_value::{AnyValue, downcast},
};

/// How much of the evidence is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Hypotheses, the paper's conclusions and the sharper companions.
    Everything,
    /// Only the paper's conclusions, observed ≤ bound, of the statements that
    /// [are bounds](tautline_statements::Statement::is_a_bound).
    PaperAlone,
}

/// One run of a check: its subject, its cases, and the part of the evidence that is judged.
#[derive(Clone, Copy, Debug)]
pub struct Trial<'a> {
    /// The implementation under test.
    pub subject: &'a Subject,
    /// The part of the evidence that is judged.
    pub scope: Scope,
    /// The maximal number of random cases per family; a family is one strategy with its seed.
    pub cases: u32,
    /// The seeds, and the factor that multiplies the numbers of cases.
    pub chance: Chance,
    /// A case that replaces all random ones.
    pub given: Option<&'a Given>,
}

impl<'a> Trial<'a> {
    /// Returns the trial with fixed seeds and at most `cases` random cases per family.
    #[must_use]
    pub const fn new(subject: &'a Subject, scope: Scope, cases: u32) -> Self {
        Self { subject, scope, cases, chance: Chance::FIXED, given: None }
    }

    /// Evaluates statements on `cases` random values, or on the [given](Trial::given) one if it
    /// belongs to this family.
    ///
    /// The same `seed` and [`chance`](Trial::chance) draw the same values.
    ///
    /// # Errors
    ///
    /// The first evidence that fails, with the seed and the smallest failing value found.
    pub fn for_all<V, E>(
        &self,
        seed: u64,
        cases: u32,
        values: V,
        evidence: impl Fn(&Subject, V::Value) -> Result<E, VerifyError>,
    ) -> Outcome
    where
        V: Strategy + 'static,
        V::Value: Any + Debug,
        E: IntoIterator<Item = Evidence>,
    {
        if let Some(given) = self.given {
            return match given.take(seed) {
                Some(value) => self.one(evidence(self.subject, value)?),
                None => Ok(Tally::default()),
            };
        }
        let mut config = self.chance.config(seed, cases);
        config.cases = config.cases.min(self.cases);
        let evidence = |value| {
            let found = evidence(self.subject, downcast(value))?;
            Ok(found.into_iter().collect())
        };
        let values = values.prop_map(|value| Box::new(value) as Box<dyn AnyValue>).boxed();
        self.scope.run(config, &values, &evidence).map_err(|error| {
            let message = format!("seed {seed}: {error}");
            let case = match &error {
                TestError::Fail(_, value) => Some(Case::of_type::<V::Value>(seed, value)),
                TestError::Abort(_) => None,
            };
            Failure { message, case }
        })
    }

    /// Judges the evidence of one case.
    ///
    /// # Errors
    ///
    /// The first evidence that fails.
    pub fn one(&self, evidence: impl IntoIterator<Item = Evidence>) -> Outcome {
        let mut tally = Tally::default();
        for evidence in evidence {
            self.scope.judge(&evidence).map_err(Failure::new)?;
            tally.count(&evidence);
        }
        Ok(tally)
    }
}

impl Scope {
    /// Judges the evidence of random values. The values are type-erased, so that the function
    /// compiles only once.
    fn run(
        self,
        config: Config,
        values: &BoxedStrategy<Box<dyn AnyValue>>,
        evidence: &dyn Fn(Box<dyn AnyValue>) -> Result<Vec<Evidence>, VerifyError>,
    ) -> Result<Tally, TestError<Box<dyn AnyValue>>> {
        let tally = RefCell::new(Tally::default());
        TestRunner::new(config).run(values, |value| {
            let found = evidence(value).map_err(|error| TestCaseError::fail(error.to_string()))?;
            for evidence in found {
                self.judge(&evidence).map_err(TestCaseError::fail)?;
                tally.borrow_mut().count(&evidence);
            }
            Ok(())
        })?;
        Ok(tally.into_inner())
    }

    fn judge(self, evidence: &Evidence) -> Result<(), String> {
        let failed = match self {
            Scope::PaperAlone => evidence
                .conclusions
                .iter()
                .find(|claim| claim.source == Source::Stated && !claim.holds())
                .filter(|_| evidence.statement.is_a_bound())
                .map(|claim| ("is violated", claim)),
            Scope::Everything => match evidence.finding() {
                Finding::Holds => None,
                Finding::Inapplicable(clause) => Some(("does not apply", clause)),
                Finding::Violated(claim) => Some(("is violated", claim)),
            },
        };
        match failed {
            None => Ok(()),
            Some((how, number)) => Err(format!("{} {how}: {number}", evidence.statement)),
        }
    }
}

/// Runs [`Trial::for_all`] on several strategies with the same evidence, each with its own seed.
/// The arguments are `(seed, strategy)` with a common number of cases, or
/// `(seed, cases, strategy)`.
///
/// This is a macro because the strategies draw different types, while a closure takes only one
/// type.
macro_rules! for_all {
    ($trial:expr, $cases:expr, [$(($seed:expr, $values:expr)),* $(,)?], $evidence:expr $(,)?) => {
        $crate::battery::harness::all([$($trial.for_all($seed, $cases, $values, $evidence)),*])
    };
    ($trial:expr, [$(($seed:expr, $cases:expr, $values:expr)),* $(,)?], $evidence:expr $(,)?) => {
        $crate::battery::harness::all([$($trial.for_all($seed, $cases, $values, $evidence)),*])
    };
}
pub(crate) use for_all;

#[cfg(test)]
mod tests {
    use tautline_statements::{LIBRARY, Statement, Subject};

    use super::{super::sample, Scope, Trial};

    #[test]
    fn everything_counts_or_only_the_bounds_of_the_paper() {
        for (name, given, stated, sharper, [everything, paper_alone]) in [
            ("all hold", 0.5, 0.5, 0.5, [true, true]),
            ("the hypothesis fails", 2.0, 0.5, 0.5, [false, true]),
            ("the bound fails", 0.5, 2.0, 0.5, [false, false]),
            ("the companion fails", 0.5, 0.5, 2.0, [false, true]),
            ("the bound is NaN", 0.5, f64::NAN, 0.5, [false, false]),
        ] {
            let passes = |scope| {
                let evidence = sample([given, 0.0], stated, sharper);
                Trial::new(&LIBRARY, scope, 1).one([evidence]).is_ok()
            };
            assert_eq!(passes(Scope::Everything), everything, "{name}");
            assert_eq!(passes(Scope::PaperAlone), paper_alone, "{name}");
        }
    }

    #[test]
    fn the_smallest_failing_case_is_found_and_kept_with_its_type() {
        let trial = Trial::new(&LIBRARY, Scope::Everything, 256);
        let bounded = |_: &Subject, k: u32| Ok([sample([0.5, 0.0], f64::from(k) / 699.0, 0.5)]);
        let failure = trial.for_all(7, 256, 0..1000_u32, bounded).expect_err("some are beyond");
        let case = failure.case.expect("a random case");
        assert_eq!((case.family, case.code), (7, ["u32", "700"].map(str::to_owned)));
        let tally = trial.for_all(7, 64, 0..700_u32, bounded).expect("none is beyond");
        assert_eq!(tally.of(Statement::Theorem1_1).map(|count| count.cases), Some(64));
    }
}
