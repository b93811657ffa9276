//! `Source`: the text of a problem file, and what a program prints about it.

use std::{
    fs,
    io::{self, IsTerminal, Read, Write},
    path::{Path, PathBuf},
};

use crate::Diagnostic;

/// The text of a problem file, with the name that messages give it.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
}

/// A file cannot be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {error}", path = path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What the system says.
    #[source]
    pub error: io::Error,
}

impl Source {
    /// Reads a file, or standard input for `-`.
    ///
    /// # Errors
    ///
    /// [`FileError`] if the file cannot be read, or is not text.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        let is_input = path == Path::new("-");
        let name = if is_input { "standard input".into() } else { path.display().to_string() };
        let mut text = String::new();
        let read = if is_input {
            io::stdin().read_to_string(&mut text).map(|_| ())
        } else {
            fs::read_to_string(path).map(|read| text = read)
        };
        match read {
            Ok(()) => Ok(Self { name, text }),
            Err(error) => Err(FileError { path: name.into(), error }),
        }
    }

    /// Returns the text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns a message with the lines of the file, in colour if standard error is a terminal.
    #[must_use]
    pub fn explain(&self, diagnostic: &Diagnostic) -> String {
        let coloured = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
        diagnostic.render(&self.name, &self.text, coloured)
    }
}

/// Prints a text to standard output. A reader that has gone away, such as `head`, is no error.
///
/// # Errors
///
/// [`FileError`] if standard output cannot be written for another reason.
pub fn print(text: &str) -> Result<(), FileError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(FileError { path: "standard output".into(), error })
        }
        _ => Ok(()),
    }
}
