//! `Diagnostic`: what is wrong with a file, and where.

use std::{fmt, ops::Range};

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// What is wrong with a file, where, and what was probably meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong.
    pub message: String,
    /// The bytes of the file that are underlined.
    pub at: Range<usize>,
    /// What stands under the line, such as what was expected; may be empty.
    pub label: String,
    /// What to do, or what was probably meant.
    pub help: Option<String>,
}

impl Diagnostic {
    pub(crate) fn new(message: impl Into<String>, at: Range<usize>) -> Self {
        Self { message: message.into(), at, label: String::new(), help: None }
    }

    pub(crate) fn label(self, label: impl Into<String>) -> Self {
        Self { label: label.into(), ..self }
    }

    pub(crate) fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// Returns the message with the line of the file, the place underlined. `coloured` adds the
    /// escape sequences of a terminal.
    #[must_use]
    pub fn render(&self, file_name: &str, file: &str, coloured: bool) -> String {
        // Places are moved to whole characters of the file.
        let whole =
            |byte: usize| (0..=byte.min(file.len())).rev().find(|&b| file.is_char_boundary(b));
        let begin = whole(self.at.start).unwrap_or(0);
        let end = whole(self.at.end).unwrap_or(0).max(begin);
        let mut place = AnnotationKind::Primary.span(begin..end);
        if !self.label.is_empty() {
            place = place.label(self.label.as_str());
        }
        let snippet = Snippet::source(file).path(file_name).annotation(place);
        let mut report = Level::ERROR.primary_title(self.message.as_str()).element(snippet);
        if let Some(help) = &self.help {
            report = report.element(Level::HELP.message(help.as_str()));
        }
        let renderer = if coloured { Renderer::styled() } else { Renderer::plain() };
        renderer.render(&[report]).to_string()
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        if !self.label.is_empty() {
            write!(f, ": {}", self.label)?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostic {}
