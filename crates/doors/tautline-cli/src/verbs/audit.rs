//! `tautline audit`, which runs the program `tautline-audit`.

use std::{
    env,
    path::PathBuf,
    process::{Command, ExitCode},
};

use crate::{arguments::Audit, error::CommandError};

const PROGRAM: &str = "tautline-audit";

/// Runs the program of the audit with the same arguments.
pub(crate) fn audit(arguments: &Audit) -> Result<ExitCode, CommandError> {
    // The program next to this one, or else the one on the path.
    let beside = env::current_exe().ok().map(|here| here.with_file_name(PROGRAM));
    let beside = beside.map(|path| path.with_extension(env::consts::EXE_EXTENSION));
    let program = beside.filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(PROGRAM));
    let status = Command::new(program).args(&arguments.arguments).status().map_err(|error| {
        CommandError::NotDone(format!(
            "the program {PROGRAM} does not start ({error}); build it next to this one with \
             cargo build --package {PROGRAM}"
        ))
    })?;
    Ok(status
        .code()
        .and_then(|code| u8::try_from(code).ok())
        .map_or(ExitCode::FAILURE, ExitCode::from))
}
