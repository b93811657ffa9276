//! `tautline completions`.

use std::process::ExitCode;

use clap::CommandFactory;

use crate::{
    arguments::{Arguments, Completions},
    error::CommandError,
    write::print,
};

/// Prints a script that completes the command in a shell.
pub(crate) fn completions(arguments: &Completions) -> Result<ExitCode, CommandError> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "tautline", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
