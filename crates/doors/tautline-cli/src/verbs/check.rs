//! `tautline check`.

use std::{io::Read, process::ExitCode, time::Instant};

use tautline_problem::check::{AnyCertificate, CheckError};

use crate::{arguments::Check, error::CommandError, timed::seconds, write::print};

/// Checks a certificate.
pub(crate) fn check(arguments: &Check) -> Result<ExitCode, CommandError> {
    let (path, limit) = (&arguments.file, seconds(arguments.time_limit)?);
    let begun = Instant::now();
    let mut text = String::new();
    let read = if path.as_os_str() == "-" {
        std::io::stdin().read_to_string(&mut text).map(|_| ())
    } else {
        std::fs::read_to_string(path).map(|read| text = read)
    };
    read.map_err(|error| CommandError::File { path: path.clone(), error })?;
    let go_on = || limit.is_none_or(|limit| begun.elapsed() < limit);
    let verdict = AnyCertificate::read(&text).and_then(|read| read.check_while(&go_on));
    let verdict = verdict.map_err(|error| match error {
        CheckError::Stopped { .. } => {
            CommandError::NotChecked(format!("not checked in the time: {error}"))
        }
        _ => CommandError::NotDone(format!("refused: {error}")),
    })?;
    match print(&format!("{}{verdict}", verdict.statement)) {
        // It is proved, also if the reader has seen enough.
        Ok(()) | Err(CommandError::Unread) => Ok(ExitCode::SUCCESS),
        Err(error) => Err(error),
    }
}
