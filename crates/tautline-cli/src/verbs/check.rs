//! `tautline check`.

use std::{io::Read, process::ExitCode};

use tautline_problem::check::AnyCertificate;

use crate::{arguments::Check, error::CommandError, write::print};

/// Checks a certificate.
pub(crate) fn check(arguments: &Check) -> Result<ExitCode, CommandError> {
    let path = &arguments.file;
    let mut text = String::new();
    let read = if path.as_os_str() == "-" {
        std::io::stdin().read_to_string(&mut text).map(|_| ())
    } else {
        std::fs::read_to_string(path).map(|read| text = read)
    };
    read.map_err(|error| CommandError::File { path: path.clone(), error })?;
    let verdict = AnyCertificate::read(&text).and_then(|certificate| certificate.check());
    let verdict = verdict.map_err(|error| CommandError::NotDone(format!("refused: {error}")))?;
    print(&format!("{}{verdict}", verdict.statement))?;
    Ok(ExitCode::SUCCESS)
}
