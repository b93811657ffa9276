//! `cargo xtask nightly`: runs all random tests with another seed and more cases.

use std::{
    path::Path,
    process::Command,
    time::{SystemTime, UNIX_EPOCH},
};

use crate::said::print;

/// The factor by which the number of cases of a test is multiplied.
const CASES: &str = "100";

/// The variables that the tests read: see `crates/companion/tautline-chance`.
const VARIABLES: [&str; 2] = ["TAUTLINE_SEED", "TAUTLINE_CASES"];

/// Tests that do not depend on the seed.
const SKIPPED: [&str; 2] = ["committed_data", "tidiness"];

/// Runs the tests with a seed from the clock and a hundred times as many cases, unless the
/// environment sets these. The arguments `rest` are passed to `cargo test`. A failure does not stop
/// other tests.
pub(crate) fn nightly(root: &Path, rest: &[&str]) -> Result<(), String> {
    let clock = SystemTime::now().duration_since(UNIX_EPOCH).map_or(1, |since| since.as_secs());
    let chosen = chosen(|name| std::env::var(name).ok(), clock);
    let arguments = arguments(rest);
    let set: String = chosen.iter().map(|(name, value)| format!("{name}={value} ")).collect();
    let line = format!("{set}cargo {}", arguments.join(" "));
    // The line is printed first, so that an interrupted run can be repeated.
    print(format!("$ {line}"))?;
    let status =
        Command::new(env!("CARGO")).args(&arguments).envs(chosen).current_dir(root).status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!(
            "`{line}` failed: {status}\nEach failure above says how to draw its case again; those of the \
             suite end with a test to paste."
        )),
        Err(error) => Err(format!("`{line}` did not start: {error}")),
    }
}

/// Returns the variables with their values, from the environment or else from the clock and
/// [`CASES`].
fn chosen(set: impl Fn(&str) -> Option<String>, clock: u64) -> [(&'static str, String); 2] {
    let [seed, cases] = VARIABLES;
    let or = |name, otherwise: String| (name, set(name).unwrap_or(otherwise));
    [or(seed, clock.to_string()), or(cases, CASES.to_owned())]
}

/// Returns the arguments for cargo: the whole workspace unless packages are named, and the skipped
/// tests after `--`.
fn arguments<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    let (cargo, test) = match rest.iter().position(|argument| *argument == "--") {
        Some(at) => (&rest[..at], &rest[at + 1..]),
        None => (rest, &rest[..0]),
    };
    // `-p tests`, `-ptests`, `--package tests` and `--package=tests` all name a package.
    let named = cargo
        .iter()
        .any(|argument| argument.starts_with("--package") || argument.starts_with("-p"));
    let scope = if named { None } else { Some("--workspace") };
    let skipped = SKIPPED.iter().flat_map(|name| ["--skip", *name]);
    let start = ["test", "--no-fail-fast", "--tests"];
    let start = start.into_iter().chain(scope).chain(cargo.iter().copied());
    start.chain(["--"]).chain(skipped).chain(test.iter().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::{arguments, chosen};

    #[test]
    fn what_the_environment_says_goes_before_the_clock() {
        let values = |given: &'static str| {
            let set = move |name: &str| (name == given).then(|| "3".to_owned());
            chosen(set, 1700).map(|(name, value)| format!("{name}={value}"))
        };
        assert_eq!(values(""), ["TAUTLINE_SEED=1700", "TAUTLINE_CASES=100"]);
        assert_eq!(values("TAUTLINE_SEED"), ["TAUTLINE_SEED=3", "TAUTLINE_CASES=100"]);
        assert_eq!(values("TAUTLINE_CASES"), ["TAUTLINE_SEED=1700", "TAUTLINE_CASES=3"]);
    }

    #[test]
    fn packages_and_names_go_to_their_places() {
        let line = |rest: &[&str]| arguments(rest).join(" ");
        let skipped = "--skip committed_data --skip tidiness";
        let start = "test --no-fail-fast --tests";
        assert_eq!(line(&[]), format!("{start} --workspace -- {skipped}"));
        for named in ["-ptests", "--package=tests", "--package tests"] {
            let words: Vec<&str> = named.split(' ').collect();
            assert_eq!(line(&words), format!("{start} {named} -- {skipped}"));
        }
        assert_eq!(
            line(&["-p", "tests", "--test", "suite", "--", "--test-threads=1"]),
            format!("{start} -p tests --test suite -- {skipped} --test-threads=1")
        );
    }
}
