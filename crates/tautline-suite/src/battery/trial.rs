//! `Trial`: one run of a check on a subject.

use std::{any::Any, cell::RefCell, fmt::Debug};

use proptest::{
    prelude::Strategy,
    test_runner::{Config, TestCaseError, TestError, TestRunner},
};
use tautline_chance::Chance;
use tautline_statements::{Evidence, Finding, Source, Subject, Units, VerifyError};

use super::{
    Tally,
    any_strategy::{AnyStrategy, AnyValue, downcast},
    promotion::{Case, Given},
};

/// How much of the evidence is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Hypotheses, the paper's conclusions and the sharper companions.
    Everything,
    /// Of random cases the paper's bounds alone, observed ≤ bound and nothing else: the conclusions
    /// of the statements that [are bounds](tautline_statements::Statement::is_a_bound).
    PaperAlone,
}

/// What a check may use: the subject, how much of the evidence counts, and how many cases.
#[derive(Clone, Copy, Debug)]
pub struct Trial<'a> {
    /// The implementation under test.
    pub subject: &'a Subject,
    /// How much of the evidence is judged.
    pub scope: Scope,
    /// At most so many random cases a family.
    pub cases: u32,
    /// From which seeds, and by which factor more cases than a check asks for.
    pub chance: Chance,
    /// One case in place of all random ones.
    pub given: Option<&'a Given>,
}

/// Why a check failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// The two numbers, the claim, and the case (of a random case, the smallest one found).
    pub message: String,
    /// That case, if it is a random one.
    pub case: Option<Case>,
}

impl Failure {
    /// Returns a failure with this message.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), case: None }
    }

    /// Returns all there is to say of it, by the name of the check: the numbers, the command that
    /// draws the same cases, and a test that keeps the smallest of them.
    #[must_use]
    pub fn of_check(&self, name: &str, chance: Chance) -> String {
        let again = format!("{self}\nagain: {chance}cargo test -p tests {name}");
        match &self.case {
            Some(case) => {
                format!(
                    "{again}\nto keep it, in tests/src/promoted_cases.rs:\n\n{}",
                    case.as_test(name)
                )
            }
            None => again,
        }
    }
}

impl From<VerifyError> for Failure {
    fn from(error: VerifyError) -> Self {
        Self::new(error.to_string())
    }
}

/// What a check says: its tally, or why it failed.
pub type Outcome = Result<Tally, Failure>;

impl<'a> Trial<'a> {
    /// Returns the trial on the cases that are always the same, at most so many a family.
    #[must_use]
    pub const fn new(subject: &'a Subject, scope: Scope, cases: u32) -> Self {
        Self { subject, scope, cases, chance: Chance::FIXED, given: None }
    }

    /// Evaluates statements on `cases` random values, always the same ones for the same `seed` and
    /// [`chance`](Trial::chance); or on the one that is [given](Trial::given), if it is of this
    /// family.
    ///
    /// # Errors
    ///
    /// The first evidence that fails, with the smallest value found for which it does, and the
    /// seed.
    pub fn for_all<V, E>(
        &self,
        seed: u64,
        cases: u32,
        values: V,
        evidence: impl Fn(&Subject, V::Value) -> Result<E, VerifyError>,
    ) -> Outcome
    where
        V: Strategy,
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
        self.scope.run(config, AnyStrategy::new(&values), &evidence).map_err(|error| {
            let message = format!("seed {seed}: {error}");
            let case = match &error {
                TestError::Fail(_, value) => Some(Case::of_type::<V::Value>(seed, value)),
                TestError::Abort(_) => None,
            };
            Failure { message, case }
        })
    }

    /// Evaluates statements on `cases` random values twice, in two systems of units, and compares:
    /// every number has to scale by its unit.
    ///
    /// The units differ by powers of two, so that a change of units rounds nothing; bounds agree
    /// to `10⁻¹²`, relatively, which leaves room for the rounding of a few hundred operations that
    /// were done in another order, and observations up to what is granted.
    ///
    /// # Errors
    ///
    /// The first number that does not scale.
    pub fn homogeneous<V, E>(
        &self,
        seed: u64,
        cases: u32,
        values: V,
        evidence: impl Fn(&Subject, V::Value, Units) -> Result<E, VerifyError>,
    ) -> Outcome
    where
        V: Strategy,
        V::Value: Any + Debug + Clone,
        E: IntoIterator<Item = Evidence>,
    {
        let units = (-3..4_i32, -3..4_i32)
            .prop_map(|(ell, m)| Units { ell: 2_f64.powi(ell), m: 2_f64.powi(m) });
        self.for_all(seed, cases, (values, units), |subject, (value, units)| {
            let here: Vec<_> = evidence(subject, value.clone(), Units::ONE)?.into_iter().collect();
            let there: Vec<_> = evidence(subject, value, units)?.into_iter().collect();
            all_scale(&here, &there, units)?;
            Ok(here)
        })
    }

    /// Evaluates statements on one given case.
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
    /// Judges the evidence of random values: compiled once, whatever is drawn.
    fn run(
        self,
        config: Config,
        values: AnyStrategy<'_>,
        evidence: &dyn Fn(Box<dyn AnyValue>) -> Result<Vec<Evidence>, VerifyError>,
    ) -> Result<Tally, TestError<Box<dyn AnyValue>>> {
        let tally = RefCell::new(Tally::default());
        TestRunner::new(config).run(&values, |value| {
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

/// Compares all evidence of the same case in two systems of units.
fn all_scale(here: &[Evidence], there: &[Evidence], units: Units) -> Result<(), VerifyError> {
    assert_eq!(here.len(), there.len(), "as much evidence in other units");
    here.iter().zip(there).try_for_each(|(here, there)| scales(here, there, units))
}

/// Compares all numbers of the same case in two systems of units.
fn scales(here: &Evidence, there: &Evidence, units: Units) -> Result<(), VerifyError> {
    let pairs = |evidence: &Evidence| {
        evidence.hypotheses.iter().chain(&evidence.conclusions).copied().collect::<Vec<_>>()
    };
    let (here, there) = (pairs(here), pairs(there));
    assert_eq!(here.len(), there.len(), "as many clauses in other units");
    for (here, there) in here.into_iter().zip(there) {
        let factor = here.unit.factor(units.ell, units.m);
        let (observed, bound) = (here.observed * factor, here.bound * factor);
        let (grant, granted) = (here.granted * factor, there.granted + here.granted * factor);
        // What is granted scales too, or it could hide that the numbers do not: errors of adaptive
        // quadratures are estimates, which differ by less than a factor of 2.
        let same_grant = there.granted <= 2.0 * grant && grant <= 2.0 * there.granted;
        // Infinities are equal, and have no difference.
        let same_bound =
            bound == there.bound || (bound - there.bound).abs() <= 1e-12 * bound.abs() + granted;
        let same = observed == there.observed || (observed - there.observed).abs() <= granted;
        if !(same && same_bound && same_grant) {
            let claim = here.claim;
            return Err(VerifyError::NotHomogeneous {
                claim,
                expected: [observed, bound],
                found: [there.observed, there.bound],
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use tautline_statements::{Evidence, LIBRARY, Statement, Subject, Unit, Units};

    use super::{Scope, Trial, scales};

    /// One hypothesis and one conclusion of Theorem 1.1, and a companion of it.
    fn evidence(given: f64, paper: f64, sharper: f64) -> Evidence {
        Evidence::of(Statement::Theorem1_1)
            .given("a hypothesis", Unit::NONE, [given, 1.0], 0.0)
            .stated("a bound", Unit::ENERGY, [paper, 1.0], 0.0)
            .sharper("a companion", Unit::ENERGY, [sharper, 1.0], 0.0)
    }

    #[test]
    fn all_that_does_not_hold_fails_and_alone_the_bounds_of_the_paper() {
        let judged =
            |scope, evidence: Evidence| Trial::new(&LIBRARY, scope, 1).one([evidence]).is_ok();
        let outcomes = |scope| {
            [evidence(0.5, 0.5, 0.5), evidence(2.0, 0.5, 0.5), evidence(0.5, 2.0, 0.5)]
                .into_iter()
                .chain([evidence(0.5, 0.5, 2.0), evidence(0.5, f64::NAN, 0.5)])
                .map(|evidence| judged(scope, evidence))
                .collect::<Vec<_>>()
        };
        assert_eq!(outcomes(Scope::Everything), [true, false, false, false, false]);
        assert_eq!(outcomes(Scope::PaperAlone), [true, true, false, true, false]);
    }

    #[test]
    fn the_smallest_case_that_fails_is_found_and_kept_by_its_type() {
        let trial = Trial::new(&LIBRARY, Scope::Everything, 256);
        let bounded = |_: &Subject, k: u32| Ok([evidence(0.5, f64::from(k) / 699.0, 0.5)]);
        let failure = trial.for_all(7, 256, 0..1000_u32, bounded).expect_err("some are beyond");
        let case = failure.case.expect("a random case");
        assert_eq!((case.family, case.code), (7, ["u32", "700"].map(str::to_owned)));
        let tally = trial.for_all(7, 64, 0..700_u32, bounded).expect("none is beyond");
        assert_eq!(tally.of(Statement::Theorem1_1).map(|count| count.cases), Some(64));
    }

    /// Lengths in units of 1/2 are twice as large, and energies four times.
    #[test]
    fn every_number_has_to_scale_by_its_unit() {
        let units = Units { ell: 1.0, m: 2.0 };
        let of = |observed: f64, bound: f64, granted: f64| {
            Evidence::of(Statement::Theorem1_1).stated(
                "a bound",
                Unit::ENERGY,
                [observed, bound],
                granted,
            )
        };
        let here = of(1.0, 3.0, 1e-9);
        assert!(scales(&here, &of(4.0, 12.0, 4e-9), units).is_ok());
        for there in [of(2.0, 12.0, 4e-9), of(4.0, 6.0, 4e-9), of(4.0, 12.0, 1e-9)] {
            assert!(scales(&here, &there, units).is_err(), "{there:?}");
        }
    }

    #[test]
    #[should_panic(expected = "as many clauses")]
    fn a_clause_that_is_missing_in_other_units_is_missed() {
        let less = Evidence::of(Statement::Theorem1_1);
        let _ = scales(&evidence(0.5, 0.5, 0.5), &less, Units::ONE);
    }
}
