//! `cargo xtask second-checker`: tests the checker in Python, and lets it check the certificates of the
//! gallery and others by chance.

use std::{env, path::Path, process::Command};

use crate::{
    peers::install,
    run::{cargo, run},
};

/// Installs what the second checker needs into `target/second-checker`, unless a Python is named that
/// has it, runs its tests, and compares the two checkers.
pub(crate) fn second_checker(root: &Path, rest: &[&str]) -> Result<(), String> {
    let python = match rest {
        [] => {
            let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into()));
            let environment = target.join("second-checker");
            let requirements = root.join("crates/library/tautline-check/second/requirements.txt");
            install(&environment, &requirements)?;
            environment.join("bin/python").display().to_string()
        }
        [python] => (*python).to_owned(),
        _ => return Err("second-checker needs at most one program, Python".to_owned()),
    };
    let checker = "crates/library/tautline-check/second";
    let folder = format!("{checker}/tests");
    let tests = ["-B", "-m", "unittest", "discover", "-s", &folder];
    run(
        Command::new(&python).args(tests).env("PYTHONPATH", root.join(checker)),
        &format!("{python} {}", tests.join(" ")),
    )?;
    cargo(&["run", "--package", "paper", "--", "second-checker", &python], &[])
}
