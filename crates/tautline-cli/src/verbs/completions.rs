//! `tautline completions`.

use std::process::ExitCode;

use clap::CommandFactory;

use tautline_problem::print;

use crate::{
    arguments::{Arguments, Completions},
    error::CommandError,
};

/// Prints a script that completes the command in a shell.
pub(crate) fn completions(arguments: &Completions) -> Result<ExitCode, CommandError> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "tautline", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
