//! `ProblemText`: a problem file that was read.

use std::path::Path;

use tautline_problem::{Failure, Question, Source};

use crate::error::CommandError;

/// A problem file, and what it asks.
pub(crate) struct ProblemText {
    source: Source,
    pub(crate) question: Question,
}

impl ProblemText {
    /// Reads a file, or standard input for `-`.
    pub(crate) fn read(path: &Path) -> Result<Self, CommandError> {
        let source = Source::read(path)?;
        match Question::read(source.text()) {
            Ok(question) => Ok(Self { source, question }),
            Err(error) => Err(CommandError::BadFile(source.explain(&error))),
        }
    }

    /// Returns a failure as an error, with the lines of the file if the file is wrong.
    pub(crate) fn explain(&self, failure: Failure) -> CommandError {
        match failure {
            Failure::BadInput(diagnostic) => {
                CommandError::BadFile(self.source.explain(&diagnostic))
            }
            Failure::NotComputed(reason) => CommandError::NotDone(reason),
        }
    }
}
