//! Runs every check of the project's own suite as a test under the name of the check.
//!
//! `cargo test -p tests --test suite -- --list` lists the tests.

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial as Test};
use tautline_checks::battery::{Check, Scope, Trial, suite};
use tautline_kit::Chance;
use tautline_statements::{LIBRARY, Mutant, Subject};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let tests =
        suite().into_iter().map(|check| Test::test(check.name, move || passes(check, &LIBRARY)));
    let tests = tests.chain([Test::test("a_check_that_fails_fails_its_test", failures_are_seen)]);
    libtest_mimic::run(&arguments, tests.collect()).exit_code()
}

/// Runs the check on the subject, which is the library.
fn passes(check: Check, subject: &Subject) -> Result<(), Failed> {
    let chance = Chance::asked();
    let trial = Trial { chance, ..Trial::new(subject, Scope::Everything, u32::MAX) };
    check.run(&trial).map_err(|failure| failure.of_check(check.name, chance))?;
    Ok(())
}

/// Not the library: some checks fail on half an energy, and they say which they are.
fn failures_are_seen() -> Result<(), Failed> {
    let name = "props_7_9_8_1_and_8_2_hold_for_random_sequences";
    let check = suite().into_iter().find(|check| check.name == name).ok_or("no such check")?;
    match passes(check, &Subject::from(Mutant::EnergyHalved)) {
        Err(failed) if failed.message().is_some_and(|message| message.contains(name)) => Ok(()),
        other => Err(format!("{name} on half an energy: {other:?}").into()),
    }
}
