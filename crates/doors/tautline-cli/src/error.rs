//! `CommandError`: why the command failed.

use std::{io, path::PathBuf, process::ExitCode};

/// Why the command failed. The message is for a person.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CommandError {
    /// A file is wrong. The text is the message with the lines of the file.
    #[error("{0}")]
    BadFile(String),
    /// An argument is wrong.
    #[error("error: {0}")]
    BadArgument(String),
    /// A file cannot be read or written.
    #[error("error: {path}: {error}", path = path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// Nothing was computed or proved.
    #[error("error: {0}")]
    NotDone(String),
    /// Time ran out before it was known whether a certificate proves something.
    #[error("error: {0}")]
    NotChecked(String),
    /// Nobody reads the output any more. There is nobody to tell, either.
    #[error("")]
    Unread,
}

impl CommandError {
    /// Returns the exit code: 2 for bad input and for a check that was not finished, otherwise 1.
    pub(crate) fn code(&self) -> ExitCode {
        match self {
            CommandError::BadFile(_)
            | CommandError::BadArgument(_)
            | CommandError::File { .. }
            | CommandError::NotChecked(_) => ExitCode::from(2),
            CommandError::NotDone(_) | CommandError::Unread => ExitCode::from(1),
        }
    }
}
