//! `ProblemText`: a problem file that was read.

use std::{
    fs,
    io::{self, IsTerminal, Read},
    path::{Path, PathBuf},
};

use tautline_problem::{Diagnostic, Failure, Question};

use crate::error::CommandError;

/// A problem file, and what it asks.
pub(crate) struct ProblemText {
    /// The name of the file in messages.
    name: String,
    text: String,
    pub(crate) question: Question,
    /// The file, unless it is standard input, and those of its tables.
    pub(crate) read: Vec<PathBuf>,
}

impl ProblemText {
    /// Reads a file, or standard input for `-`.
    pub(crate) fn read(path: &Path) -> Result<Self, CommandError> {
        let is_input = path == Path::new("-");
        let name = if is_input { "standard input".into() } else { path.display().to_string() };
        let mut text = String::new();
        let read = if is_input {
            io::stdin().read_to_string(&mut text).map(|_| ())
        } else {
            fs::read_to_string(path).map(|read| text = read)
        };
        read.map_err(|error| CommandError::File { path: PathBuf::from(&name), error })?;
        // The files of a problem on standard input are found from the folder in which the command runs.
        let folder = path.parent().filter(|_| !is_input).unwrap_or(Path::new(""));
        let mut read = if is_input { Vec::new() } else { vec![path.to_owned()] };
        match Question::read_with(&text, &mut |file| open(folder, file, &mut read)) {
            Ok(question) => Ok(Self { name, text, question, read }),
            Err(error) => Err(bad_file(&name, &text, &error)),
        }
    }

    /// Returns a failure as an error, with the lines of the file if the file is wrong.
    pub(crate) fn explain(&self, failure: Failure) -> CommandError {
        match failure {
            Failure::BadInput(diagnostic) => bad_file(&self.name, &self.text, &diagnostic),
            Failure::NotComputed(reason) => CommandError::NotDone(reason),
        }
    }
}

/// Returns the bytes of a file that a problem file names, or why it cannot be read. Its path is added to
/// those that are `read`.
pub(crate) fn open(folder: &Path, file: &str, read: &mut Vec<PathBuf>) -> Result<Vec<u8>, String> {
    let path = folder.join(file);
    let bytes = fs::read(&path).map_err(|error| error.to_string())?;
    read.push(path);
    Ok(bytes)
}

/// Returns the error of a file, with its lines.
pub(crate) fn bad_file(name: &str, text: &str, diagnostic: &Diagnostic) -> CommandError {
    let coloured = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    CommandError::BadFile(diagnostic.render(name, text, coloured))
}
