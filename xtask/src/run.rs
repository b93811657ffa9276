//! Runs commands in the root of the workspace.

use std::{
    env,
    path::{Path, PathBuf},
    process::Command,
};

use crate::said::say;

/// Returns the root of the workspace.
pub(crate) fn root() -> PathBuf {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask).to_owned()
}

/// Runs cargo in the root of the workspace.
pub(crate) fn cargo(arguments: &[&str], environment: &[(&str, &str)]) -> Result<(), String> {
    let set: String =
        environment.iter().map(|(name, value)| format!("{name}='{value}' ")).collect();
    let line = format!("{set}cargo {}", arguments.join(" "));
    let mut command = Command::new(env!("CARGO"));
    run(command.args(arguments).envs(environment.iter().copied()), &line)
}

/// Runs a command in the root of the workspace. It first prints the command as `line`, so that a
/// failing command can be pasted and run again.
pub(crate) fn run(command: &mut Command, line: &str) -> Result<(), String> {
    say(format!("$ {line}"));
    match command.current_dir(root()).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{line}` failed: {status}")),
        Err(error) => Err(format!("`{line}` did not start: {error}")),
    }
}
