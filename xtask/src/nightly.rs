//! `cargo xtask nightly`: everything random with other seeds and more cases.

use std::{
    path::Path,
    process::Command,
    time::{SystemTime, UNIX_EPOCH},
};

/// So many times the cases of a test.
const CASES: &str = "100";

/// The variables that the tests read: see `crates/tautline-chance`.
const VARIABLES: [&str; 2] = ["TAUTLINE_SEED", "TAUTLINE_CASES"];

/// What no seed changes.
const SKIPPED: [&str; 2] = ["committed_data", "tidiness"];

/// Runs the tests with a seed from the clock and a hundred times the cases, or with those of the
/// environment; `rest` goes to `cargo test`. All of it is run, whatever fails.
pub(crate) fn nightly(root: &Path, rest: &[&str]) -> Result<(), String> {
    let clock = SystemTime::now().duration_since(UNIX_EPOCH).map_or(1, |since| since.as_secs());
    let [seed, cases] = VARIABLES;
    let chosen =
        [(seed, chosen(seed, clock.to_string())), (cases, chosen(cases, CASES.to_owned()))];
    let arguments = arguments(rest);
    let set: String = chosen.iter().map(|(name, value)| format!("{name}={value} ")).collect();
    let line = format!("{set}cargo {}", arguments.join(" "));
    // Before anything else, so that a night that ends early can be had again.
    println!("$ {line}");
    let status =
        Command::new(env!("CARGO")).args(&arguments).envs(chosen).current_dir(root).status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!(
            "`{line}` failed: {status}\nEach failure above says how to draw its case again; the ones of \
             the suite end with a test to paste."
        )),
        Err(error) => Err(format!("`{line}` did not start: {error}")),
    }
}

/// What the environment says, or else this.
fn chosen(name: &str, otherwise: String) -> String {
    std::env::var(name).unwrap_or(otherwise)
}

/// The arguments for cargo: the whole workspace, unless packages are named; and behind `--` what
/// is left out.
fn arguments<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    let (cargo, test) = match rest.iter().position(|argument| *argument == "--") {
        Some(at) => (&rest[..at], &rest[at + 1..]),
        None => (rest, &rest[..0]),
    };
    // As `-p tests`, `-ptests`, `--package tests` and `--package=tests`.
    let named = cargo
        .iter()
        .any(|argument| argument.starts_with("--package") || argument.starts_with("-p"));
    let scope = if named { None } else { Some("--workspace") };
    let skipped = SKIPPED.iter().flat_map(|name| ["--skip", *name]);
    let start = ["test", "--no-fail-fast", "--lib", "--tests"];
    let start = start.into_iter().chain(scope).chain(cargo.iter().copied());
    start.chain(["--"]).chain(skipped).chain(test.iter().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::arguments;

    #[test]
    fn packages_and_names_go_to_their_places() {
        let line = |rest: &[&str]| arguments(rest).join(" ");
        let skipped = "--skip committed_data --skip tidiness";
        let start = "test --no-fail-fast --lib --tests";
        assert_eq!(line(&[]), format!("{start} --workspace -- {skipped}"));
        for named in ["-ptests", "--package=tests", "--package tests"] {
            let words: Vec<&str> = named.split(' ').collect();
            assert_eq!(line(&words), format!("{start} {named} -- {skipped}"));
        }
        assert_eq!(
            line(&["-p", "tests", "battery", "--", "--test-threads=1"]),
            format!("{start} -p tests battery -- {skipped} --test-threads=1")
        );
    }
}
