//! Runs every check of the project's own suite as a test under the name of the check.
//!
//! `cargo test -p tests --test suite -- --list` lists the tests.

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial as Test};
use tautline_kit::Chance;
use tautline_statements::LIBRARY;
use tautline_suite::battery::{Check, Scope, Trial, suite};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let tests = suite().into_iter().map(|check| Test::test(check.name, move || passes(check)));
    libtest_mimic::run(&arguments, tests.collect()).exit_code()
}

/// Runs the check on the library.
fn passes(check: Check) -> Result<(), Failed> {
    let chance = Chance::asked();
    let trial = Trial { chance, ..Trial::new(&LIBRARY, Scope::Everything, u32::MAX) };
    check.run(&trial).map_err(|failure| failure.of_check(check.name, chance))?;
    Ok(())
}
