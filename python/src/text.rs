//! What is wrong with a text, shown in the user's own words.

use tautline::formula::{Problem, TextError};
use tautline_any::GivenError;

/// Returns an error as a message. Places in a text are shown with its line, and count from the end of
/// the `skipped` bytes that were put before it.
pub(crate) fn message(error: &GivenError, text: &str, skipped: usize) -> String {
    let GivenError::Text(error) = error else { return error.to_string() };
    let TextError { at, problem } = error;
    let help = error.help(text.get(..at.start).unwrap_or_default(), &[]).or_else(|| {
        let is_name = matches!(problem, Problem::UnknownName { .. });
        is_name.then(|| {
            "coordinates are x1, x2, …, and `parameters` gives values to other names".into()
        })
    });
    let hint = help.map_or(String::new(), |help| format!("; {help}"));
    let place = at.start.max(skipped).min(text.len());
    // The beginning of the character there.
    let start = (0..=place).rev().find(|&byte| text.is_char_boundary(byte)).unwrap_or(0);
    // The bracket that was put behind it belongs to nobody.
    let end = if skipped > 0 { text.len().saturating_sub(1).max(skipped) } else { text.len() };
    let own = text.get(skipped..end).unwrap_or(text);
    let before = text.get(skipped..start.min(end)).unwrap_or(own);
    let line = own.lines().nth(before.matches('\n').count()).unwrap_or(own);
    let place = before.chars().count();
    let column = before.rsplit('\n').next().map_or(0, |last| last.chars().count());
    format!("at character {place}: {problem}{hint}\n    {line}\n    {:column$}^", "")
}
