//! Reads a file word for word, and explains what TOML or the types refuse.

use std::ops::Range;

use tautline::formula::probably_meant;
use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

use crate::{Diagnostic, file::ProblemFile};

/// Reads a problem file word for word.
pub(crate) fn parse(file: &str) -> Result<ProblemFile, Diagnostic> {
    let problem = toml::from_str(file).map_err(|error| explain(&error, file))?;
    let document = DeTable::parse(file).map_err(|error| explain(&error, file))?;
    match document.get_ref().values().find_map(lost) {
        None => Ok(problem),
        Some(at) => Err(Diagnostic::new("this number is too small for a double", at)
            .label("expected 0, or a number of at least 5e-324")),
    }
}

/// Returns the place of a number in a value that is read as 0 and is not 0.
fn lost(value: &Spanned<DeValue<'_>>) -> Option<Range<usize>> {
    match value.get_ref() {
        DeValue::Float(number) => {
            let number = number.as_str();
            let mantissa = number.split(['e', 'E']).next().unwrap_or_default();
            let is_lost = number.parse() == Ok(0.0)
                && mantissa.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
            is_lost.then(|| value.span())
        }
        DeValue::Array(items) => items.iter().find_map(lost),
        DeValue::Table(table) => table.values().find_map(lost),
        _ => None,
    }
}

fn explain(error: &toml::de::Error, file: &str) -> Diagnostic {
    let at = error.span().unwrap_or(file.len()..file.len());
    let message = error.message().trim_end();
    let unknown =
        ["unknown field", "unknown variant"].iter().any(|&begin| message.starts_with(begin));
    if unknown {
        let mut words = quoted(message);
        let word = words.next().unwrap_or_default();
        let known: Vec<&str> = words.collect();
        let after =
            file.get(at.end..).unwrap_or_default().trim_start_matches(['"', '\'', ' ', '\t']);
        let what = if after.starts_with(['=', '.', ']']) { "key" } else { "word" };
        let diagnostic = Diagnostic::new(format!("unknown {what} {word}"), at)
            .label(format!("expected {}", listed(&known)));
        if (word, known.contains(&"trapezoidal")) == ("midpoint", true) {
            return diagnostic.help("most books call trapezoidal the midpoint rule");
        }
        if (word, known.contains(&"spline")) == ("interpolate", true) {
            return diagnostic.help(
                "a table has its numbers unless it is asked to smooth them; spline = \"cubic\" is the cubic \
                 spline through them",
            );
        }
        if ["rule", "n", "tolerance", "starts", "steps", "time_limit"].contains(&word)
            && known.contains(&"solve")
        {
            return diagnostic.help(format!("{word} belongs in [solve]"));
        }
        return match probably_meant(word, known) {
            Some(meant) => diagnostic.help(format!("did you mean {meant}?")),
            None => diagnostic,
        };
    }
    if let Some(rest) = message.strip_prefix("missing field ") {
        let name = rest.trim_matches('`');
        let diagnostic = Diagnostic::new(format!("{name} is missing"), at);
        return match name {
            "metric" => diagnostic.help("a section such as [metric] with phi = \"2 - cos(x1)\""),
            _ => diagnostic,
        };
    }
    if message.starts_with("wanted exactly 1 element") {
        let keys = keys(file, &at);
        let names: Vec<&str> = keys.iter().flatten().map(String::as_str).collect();
        let message = match (&keys, &names[..]) {
            (Some(_), []) => "no key says what this is".to_owned(),
            // Other keys stand in sections of their own.
            (_, [] | [_]) => "several keys say what this is".to_owned(),
            (_, names) => format!("{} say what this is", all(names)),
        };
        let diagnostic = Diagnostic::new(message, at).label("expected one key");
        let misplaced = ["from", "to", "dimension"].iter().any(|key| names.contains(key));
        return if misplaced {
            diagnostic
                .help("from, to and dimension belong above [metric], or in sections of their own")
        } else {
            diagnostic
        };
    }
    if message.starts_with("wanted string or table") {
        return Diagnostic::new("this is no set", at)
            .label("expected a key and a value, such as { point = [0, 0] }");
    }
    if message.starts_with("string values must be quoted") {
        return Diagnostic::new(message, at)
            .help("an expression stands in quotes: \"2 - cos(x1)\"");
    }
    let wrong = ["invalid type: ", "invalid value: "];
    if let Some((found, expected)) = wrong
        .iter()
        .find_map(|begin| message.strip_prefix(begin))
        .and_then(|rest| rest.split_once(", expected "))
    {
        return Diagnostic::new(format!("found {}", plain_value(found)), at)
            .label(format!("expected {}", plain_type(expected)));
    }
    Diagnostic::new(message, at)
}

/// Returns the keys of a table of which this is the heading, or all in braces; `None` for a table
/// that is written in another way.
fn keys(file: &str, at: &Range<usize>) -> Option<Vec<String>> {
    let table = file.get(at.clone())?;
    let text = match table.chars().next()? {
        '{' => format!("table = {table}"),
        '[' => format!("[table]{}", file.get(at.end..)?),
        _ => return None,
    };
    let table: toml::Table = text.parse().ok()?;
    Some(table.get("table")?.as_table()?.keys().cloned().collect())
}

/// Returns a value without the name of its type in Rust.
fn plain_value(found: &str) -> String {
    match found {
        "map" => "a table".to_owned(),
        "sequence" => "a list".to_owned(),
        _ => {
            let types = ["integer ", "floating point ", "boolean "];
            let value = types.iter().find_map(|of| found.strip_prefix(of));
            value.map_or(found, |value| value.trim_matches('`')).to_owned()
        }
    }
}

/// Returns the name of a type in plain words.
fn plain_type(expected: &str) -> &str {
    match expected {
        "usize" | "u32" | "u64" => "a whole number, at least 0",
        "a sequence" => "a list in brackets, such as [0, 1]",
        "a boolean" => "true or false",
        _ if expected.starts_with("struct ") => "keys and values in braces",
        _ => expected,
    }
}

/// Returns the words between backquotes.
fn quoted(message: &str) -> impl Iterator<Item = &str> {
    message.split('`').skip(1).step_by(2)
}

/// Returns the words with commas and an `or`.
fn listed(words: &[&str]) -> String {
    joined(words, "or")
}

/// Returns the words with commas and an `and`.
pub(crate) fn all(words: &[&str]) -> String {
    joined(words, "and")
}

fn joined(words: &[&str], by: &str) -> String {
    match words {
        [] => "nothing".to_owned(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} {by} {last}", first.join(", ")),
    }
}
