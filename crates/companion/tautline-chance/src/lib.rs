//! Seeds and numbers of random cases for the tests of this workspace.
//!
//! Every test has its own fixed seed, so that each run draws the same cases; all laws of one suite
//! of `tautline-kit` share a seed. Two environment variables change the seeds and the numbers of
//! cases of all tests, including those that `tautline-kit` generates:
//!
//! | variable | a whole number that | default |
//! | --- | --- | --- |
//! | `TAUTLINE_SEED` | is mixed with the seed of each test: new cases, the same for the same number | the seed of the test |
//! | `TAUTLINE_CASES` | multiplies the number of cases of each test | 1 |
//!
//! ```console
//! $ TAUTLINE_SEED=7 TAUTLINE_CASES=100 cargo test -p tautline-bounds
//! ```
//!
//! This crate is only for tests, since [`Chance::asked`] reads the environment. Proptest reads its
//! own variables (`PROPTEST_…`) too, but only for the settings that this crate leaves open; the
//! seeds, the cases and the generator are set here.

mod random;

use std::{env, fmt};

use proptest::test_runner::{Config, RngAlgorithm, RngSeed};

pub use random::Random;

/// The variable that is mixed with every seed.
const SEED: &str = "TAUTLINE_SEED";

/// The variable that multiplies every number of cases.
const CASES: &str = "TAUTLINE_CASES";

/// The number of samples that proptest may reject by default, before [`CASES`] multiplies it.
const REJECTED: u32 = 1024;

/// The seed, and the factor on the numbers of cases, that a run uses.
///
/// `Display` writes the variables, each followed by a space, as a prefix for a command that should
/// draw the same cases. It writes nothing if the run uses the defaults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chance {
    seed: Option<u64>,
    factor: u32,
}

/// The error for an environment variable whose value is no valid number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{variable} is {value:?}, not a whole number from {least} to {most}")]
pub struct ChanceError {
    /// The name of the variable.
    pub variable: &'static str,
    /// Its value.
    pub value: String,
    /// The least valid number.
    pub least: u64,
    /// The greatest valid number.
    pub most: u64,
}

impl Chance {
    /// Keeps seeds and numbers of cases as they are in the code.
    pub const FIXED: Self = Self { seed: None, factor: 1 };

    /// Returns the seed and the factor that the environment asks for.
    ///
    /// # Panics
    ///
    /// Panics with the [`ChanceError`] if a variable has no valid number, so that every test fails.
    #[must_use]
    pub fn asked() -> Self {
        Self::read().unwrap_or_else(|error| panic!("{error}"))
    }

    /// Returns the seed and the factor that the environment asks for.
    ///
    /// # Errors
    ///
    /// [`ChanceError`] if a variable has no valid number.
    pub fn read() -> Result<Self, ChanceError> {
        let value = |name| env::var_os(name).map(|value| value.to_string_lossy().into_owned());
        Self::new(value(SEED).as_deref(), value(CASES).as_deref())
    }

    /// Returns the seed and the factor given by these values of `TAUTLINE_SEED` and
    /// `TAUTLINE_CASES`.
    ///
    /// # Errors
    ///
    /// [`ChanceError`] unless `seed` is a `u64` and `cases` is a positive `u32`.
    pub fn new(seed: Option<&str>, cases: Option<&str>) -> Result<Self, ChanceError> {
        let most = u64::from(u32::MAX);
        let seed = seed.map(|value| number(SEED, value, 0, u64::MAX)).transpose()?;
        let factor = cases.map_or(Ok(1), |value| number(CASES, value, 1, most))?;
        Ok(Self { seed, factor: u32::try_from(factor).unwrap_or(u32::MAX) })
    }

    /// Returns the seed to use for the test whose own seed is `fixed`. Tests with different seeds
    /// keep different seeds.
    #[must_use]
    pub fn seed(self, fixed: u64) -> u64 {
        let mixed = |number| Random(number).bits();
        self.seed.map_or(fixed, |seed| mixed(seed ^ mixed(fixed)))
    }

    /// Returns the number of cases to use for a test with `fixed` cases by default.
    #[must_use]
    pub fn cases(self, fixed: u32) -> u32 {
        fixed.saturating_mul(self.factor)
    }

    /// Returns the configuration of a property test with this seed and number of cases. It writes
    /// no files.
    #[must_use]
    pub fn config(self, seed: u64, cases: u32) -> Config {
        Config {
            cases: self.cases(cases),
            rng_algorithm: RngAlgorithm::ChaCha,
            rng_seed: RngSeed::Fixed(self.seed(seed)),
            max_global_rejects: self.cases(REJECTED),
            failure_persistence: None,
            ..Config::default()
        }
    }
}

/// Returns the configuration of a property test with this seed and number of cases, both modified
/// as the environment asks. The test writes no files.
///
/// The function prints to stderr how to draw the same cases; the test harness shows this output if
/// the test fails.
///
/// # Panics
///
/// Panics if [`Chance::asked`] does.
#[must_use]
pub fn config(seed: u64, cases: u32) -> Config {
    announced(seed).config(seed, cases)
}

/// Returns the seed of a test that draws its own cases, modified as the environment asks. The
/// function prints to stderr as [`config`] does.
///
/// # Panics
///
/// Panics if [`Chance::asked`] does.
#[must_use]
pub fn seed(fixed: u64) -> u64 {
    announced(fixed).seed(fixed)
}

/// Returns the number of cases of a test that draws its own, modified as the environment asks.
///
/// # Panics
///
/// Panics if [`Chance::asked`] does.
#[must_use]
pub fn cases(fixed: u32) -> u32 {
    Chance::asked().cases(fixed)
}

fn announced(seed: u64) -> Chance {
    let chance = Chance::asked();
    eprintln!("seed {seed}; to draw the same cases: {chance}cargo test");
    chance
}

impl fmt::Display for Chance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(seed) = self.seed {
            write!(f, "{SEED}={seed} ")?;
        }
        if self.factor != 1 {
            write!(f, "{CASES}={} ", self.factor)?;
        }
        Ok(())
    }
}

fn number(variable: &'static str, value: &str, least: u64, most: u64) -> Result<u64, ChanceError> {
    let number = value.trim().parse().ok().filter(|number| (least..=most).contains(number));
    number.ok_or_else(|| ChanceError { variable, value: value.to_owned(), least, most })
}

#[cfg(test)]
mod tests {
    use std::{
        collections::BTreeSet,
        env,
        process::{Command, Output},
    };

    use proptest::test_runner::{RngAlgorithm, RngSeed};

    use super::{Chance, ChanceError, cases, config, seed};

    fn asked(seed: Option<&str>, cases: Option<&str>) -> Chance {
        Chance::new(seed, cases).expect("numbers")
    }

    #[test]
    fn without_variables_nothing_changes() {
        let chance = asked(None, None);
        assert_eq!(chance, Chance::FIXED);
        assert_eq!((chance.seed(7101), chance.cases(256)), (7101, 256));
        assert_eq!(chance.to_string(), "");
        let config = chance.config(3, 64);
        assert_eq!((config.rng_seed, config.cases), (RngSeed::Fixed(3), 64));
        assert!(config.failure_persistence.is_none());
    }

    /// The variable from which the test in a child process reads what to expect.
    const DRAWN: &str = "TAUTLINE_TESTS_DRAWN";

    /// Runs the next test in a child process with these variables, which should have the effect of
    /// `asked`.
    fn in_environment(variables: &[(&str, &str)], asked: Chance) -> Output {
        let of_config = RngSeed::Fixed(asked.seed(3));
        let drawn = (asked.seed(7), asked.cases(5), of_config, asked.cases(64), asked.cases(1024));
        Command::new(env::current_exe().expect("this program"))
            .args(["--exact", "tests::the_environment_variables_have_these_names", "--nocapture"])
            .env_remove("TAUTLINE_SEED")
            .env_remove("TAUTLINE_CASES")
            .envs(variables.iter().copied())
            .env(DRAWN, format!("{drawn:?}"))
            .output()
            .expect("it starts")
    }

    #[test]
    fn the_environment_variables_have_these_names() {
        if let Some(asked) = env::var_os(DRAWN) {
            let of = config(3, 64);
            assert_eq!(of.rng_algorithm, RngAlgorithm::ChaCha);
            let drawn = (seed(7), cases(5), of.rng_seed, of.cases, of.max_global_rejects);
            return assert_eq!(asked.to_string_lossy(), format!("{drawn:?}"));
        }
        for (variables, seed, cases) in [
            (&[][..], None, None),
            (&[("TAUTLINE_SEED", "7")], Some("7"), None),
            (&[("TAUTLINE_CASES", "100")], None, Some("100")),
            (&[("TAUTLINE_SEED", "9"), ("TAUTLINE_CASES", "2")], Some("9"), Some("2")),
            // Proptest's own variables have no effect.
            (&[("PROPTEST_RNG_ALGORITHM", "xs"), ("PROPTEST_CASES", "1")], None, None),
            (&[("PROPTEST_RNG_SEED", "1"), ("PROPTEST_MAX_GLOBAL_REJECTS", "1")], None, None),
        ] {
            let output = in_environment(variables, asked(seed, cases));
            let printed = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{variables:?}: {printed}");
            let again = format!("seed 7; to draw the same cases: {}cargo test", asked(seed, cases));
            assert!(printed.contains(&again), "{printed}");
        }
        let output = in_environment(&[("TAUTLINE_CASES", "many")], Chance::FIXED);
        let printed = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{printed}");
        assert!(printed.contains("TAUTLINE_CASES is \"many\""), "{printed}");
    }

    /// Different tests and different runs draw different cases, and a run can be repeated.
    #[test]
    fn seeds_are_distinct_and_reproducible() {
        let seeds = |asked: u64| {
            (0..1000).map(move |fixed| {
                Chance::new(Some(&asked.to_string()), None).expect("a number").seed(fixed)
            })
        };
        let distinct: BTreeSet<u64> = (0..10).flat_map(seeds).chain(0..1000).collect();
        assert_eq!(distinct.len(), 11_000);
        assert!(seeds(4).eq(seeds(4)));
    }

    #[test]
    fn numbers_of_cases_and_of_rejects_are_multiplied() {
        let chance = asked(None, Some("100"));
        assert_eq!((chance.seed(5), chance.cases(64), chance.cases(u32::MAX)), (5, 6400, u32::MAX));
        assert_eq!(chance.config(3, 64).max_global_rejects, 102_400);
    }

    #[test]
    fn it_displays_as_variables_before_a_command() {
        let both = asked(Some("7"), Some("100"));
        assert_eq!(both.to_string(), "TAUTLINE_SEED=7 TAUTLINE_CASES=100 ");
        assert_eq!(asked(None, Some("2")).to_string(), "TAUTLINE_CASES=2 ");
    }

    #[test]
    fn invalid_numbers_are_errors_that_name_the_variable() {
        let error = |variable, value: &str, least, most| {
            Err(ChanceError { variable, value: value.to_owned(), least, most })
        };
        let most = u64::from(u32::MAX);
        for value in ["", "-1", "1.5", "seven", "18446744073709551616"] {
            let found = Chance::new(Some(value), None);
            assert_eq!(found, error("TAUTLINE_SEED", value, 0, u64::MAX));
        }
        for value in ["0", "4294967296", "many"] {
            let found = Chance::new(None, Some(value));
            assert_eq!(found, error("TAUTLINE_CASES", value, 1, most));
        }
        assert_eq!(
            Chance::new(None, Some("0")).expect_err("none").to_string(),
            "TAUTLINE_CASES is \"0\", not a whole number from 1 to 4294967295"
        );
    }
}
