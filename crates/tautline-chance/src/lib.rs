//! What chance decides in a test: the seed of its random cases, and how many there are.
//!
//! Every test has a seed of its own, and the laws of one suite of the kit have one together, so that it draws
//! the same cases in every run. Two environment variables change that for all of them, in the tests of this
//! workspace and in those that `tautline-kit` makes:
//!
//! | variable | a whole number that | default |
//! | --- | --- | --- |
//! | `TAUTLINE_SEED` | is mixed with the seed of each test: other cases, and again the same ones for the same number | the seed of the test |
//! | `TAUTLINE_CASES` | multiplies the number of cases of each test | 1 |
//!
//! ```console
//! $ TAUTLINE_SEED=7 TAUTLINE_CASES=100 cargo test -p tautline-bounds
//! ```
//!
//! This is for tests: [`Chance::asked`] reads the environment, and so does proptest for the settings
//! that are not set here (`PROPTEST_…`): not for seeds, cases, and what is drawn.

use std::{env, fmt};

use proptest::test_runner::{Config, RngAlgorithm, RngSeed};

/// The variable that is mixed with every seed.
const SEED: &str = "TAUTLINE_SEED";

/// The variable by which every number of cases is multiplied.
const CASES: &str = "TAUTLINE_CASES";

/// proptest's own number of samples that may be refused, for the number of cases as it is written.
const REFUSED: u32 = 1024;

/// The seed and the number of cases that were asked for.
///
/// Printed, it is what has to stand before a command so that it draws the same cases, with a blank
/// after it; nothing if seeds and numbers are as they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chance {
    seed: Option<u64>,
    factor: u32,
}

/// A variable that does not say what it should.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{variable} is {value:?}, not a whole number from {least} to {most}")]
pub struct ChanceError {
    /// The name of the variable.
    pub variable: &'static str,
    /// Its value.
    pub value: String,
    /// The least number that it may be.
    pub least: u64,
    /// The largest number that it may be.
    pub most: u64,
}

impl Chance {
    /// Seeds and numbers of cases as they are written.
    pub const FIXED: Self = Self { seed: None, factor: 1 };

    /// Returns what the environment asks for.
    ///
    /// # Panics
    ///
    /// If a variable is set to something else than a number: the tests of a command that asks for
    /// nothing sensible fail, each with the [`ChanceError`].
    #[must_use]
    pub fn asked() -> Self {
        Self::read().unwrap_or_else(|error| panic!("{error}"))
    }

    /// Returns what the environment asks for.
    ///
    /// # Errors
    ///
    /// [`ChanceError`] if a variable is set to something else than a number.
    pub fn read() -> Result<Self, ChanceError> {
        let value = |name| env::var_os(name).map(|value| value.to_string_lossy().into_owned());
        Self::new(value(SEED).as_deref(), value(CASES).as_deref())
    }

    /// Returns what these values of `TAUTLINE_SEED` and `TAUTLINE_CASES` ask for.
    ///
    /// # Errors
    ///
    /// [`ChanceError`] unless the first is a number of 64 bits, and the second one from 1 on of 32.
    pub fn new(seed: Option<&str>, cases: Option<&str>) -> Result<Self, ChanceError> {
        let most = u64::from(u32::MAX);
        let seed = seed.map(|value| number(SEED, value, 0, u64::MAX)).transpose()?;
        let factor = cases.map_or(Ok(1), |value| number(CASES, value, 1, most))?;
        Ok(Self { seed, factor: u32::try_from(factor).unwrap_or(u32::MAX) })
    }

    /// Returns the seed for a test whose own seed is this one: different for different tests.
    #[must_use]
    pub fn seed(self, fixed: u64) -> u64 {
        self.seed.map_or(fixed, |seed| mixed(seed ^ mixed(fixed)))
    }

    /// Returns the number of cases for a test that draws so many by itself.
    #[must_use]
    pub fn cases(self, fixed: u32) -> u32 {
        fixed.saturating_mul(self.factor)
    }

    /// Returns the configuration of a property test with this seed and so many cases, which writes
    /// no files.
    #[must_use]
    pub fn config(self, seed: u64, cases: u32) -> Config {
        Config {
            cases: self.cases(cases),
            rng_algorithm: RngAlgorithm::ChaCha,
            rng_seed: RngSeed::Fixed(self.seed(seed)),
            max_global_rejects: self.cases(REFUSED),
            failure_persistence: None,
            ..Config::default()
        }
    }
}

/// Returns the configuration of a property test with this seed and so many cases, or what the
/// environment asks for instead; it writes no files.
///
/// Says on stderr how to draw the same cases, which the test harness shows where the test fails.
///
/// # Panics
///
/// As [`Chance::asked`].
#[must_use]
pub fn config(seed: u64, cases: u32) -> Config {
    said(seed).config(seed, cases)
}

/// Returns the seed of a test that draws by itself, or what the environment asks for instead; says
/// so, as [`config`] does.
///
/// # Panics
///
/// As [`Chance::asked`].
#[must_use]
pub fn seed(fixed: u64) -> u64 {
    said(fixed).seed(fixed)
}

/// Returns how many cases a test draws that draws by itself, or what the environment asks for.
///
/// # Panics
///
/// As [`Chance::asked`].
#[must_use]
pub fn cases(fixed: u32) -> u32 {
    Chance::asked().cases(fixed)
}

fn said(seed: u64) -> Chance {
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

/// A permutation of the numbers of 64 bits in which neighbours have nothing in common: the last step
/// of SplitMix64 (Steele, Lea and Flood, 2014), after an odd number that keeps 0 from staying 0.
fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
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
    fn without_variables_everything_is_as_it_is_written() {
        let chance = asked(None, None);
        assert_eq!(chance, Chance::FIXED);
        assert_eq!(
            (chance.seed(7101), chance.cases(256), chance.to_string()),
            (7101, 256, "".into())
        );
        let config = chance.config(3, 64);
        assert_eq!((config.rng_seed, config.cases), (RngSeed::Fixed(3), 64));
        assert!(config.failure_persistence.is_none());
    }

    /// Set in a process whose environment asks for something, to what it is to draw.
    const DRAWN: &str = "TAUTLINE_TESTS_DRAWN";

    /// Runs the next test in a process in which these variables are set, and which is to draw what this
    /// one asks for.
    fn in_environment(variables: &[(&str, &str)], asked: Chance) -> Output {
        let of_config = RngSeed::Fixed(asked.seed(3));
        let drawn = (asked.seed(7), asked.cases(5), of_config, asked.cases(64), asked.cases(1024));
        Command::new(env::current_exe().expect("this program"))
            .args(["--exact", "tests::the_environment_is_asked_under_these_names", "--nocapture"])
            .env_remove("TAUTLINE_SEED")
            .env_remove("TAUTLINE_CASES")
            .envs(variables.iter().copied())
            .env(DRAWN, format!("{drawn:?}"))
            .output()
            .expect("it starts")
    }

    #[test]
    fn the_environment_is_asked_under_these_names() {
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
            // proptest has variables of its own.
            (&[("PROPTEST_RNG_ALGORITHM", "xs"), ("PROPTEST_CASES", "1")], None, None),
            (&[("PROPTEST_RNG_SEED", "1"), ("PROPTEST_MAX_GLOBAL_REJECTS", "1")], None, None),
        ] {
            let output = in_environment(variables, asked(seed, cases));
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{variables:?}: {said}");
            let again = format!("seed 7; to draw the same cases: {}cargo test", asked(seed, cases));
            assert!(said.contains(&again), "{said}");
        }
        let output = in_environment(&[("TAUTLINE_CASES", "many")], Chance::FIXED);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains("TAUTLINE_CASES is \"many\""), "{said}");
    }

    /// Neither two tests nor two runs share their cases, and a run can be had again.
    #[test]
    fn a_seed_gives_every_test_another_one() {
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
    fn numbers_of_cases_are_multiplied_and_so_is_what_may_be_refused() {
        let chance = asked(None, Some("100"));
        assert_eq!((chance.seed(5), chance.cases(64), chance.cases(u32::MAX)), (5, 6400, u32::MAX));
        assert_eq!(chance.config(3, 64).max_global_rejects, 102_400);
    }

    #[test]
    fn it_prints_as_what_stands_before_a_command() {
        assert_eq!(
            asked(Some("7"), Some("100")).to_string(),
            "TAUTLINE_SEED=7 TAUTLINE_CASES=100 "
        );
        assert_eq!(asked(None, Some("2")).to_string(), "TAUTLINE_CASES=2 ");
    }

    #[test]
    fn what_is_no_number_is_refused_with_its_name() {
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
