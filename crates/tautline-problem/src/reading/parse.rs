//! Reads a file word for word, and explains what TOML or the types refuse.

use crate::{
    Diagnostic,
    file::ProblemFile,
    reading::meant::{probably_meant, quoted},
};

/// Reads a problem file word for word.
pub(crate) fn parse(file: &str) -> Result<ProblemFile, Diagnostic> {
    toml::from_str(file).map_err(|error| explain(&error, file))
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
        let diagnostic = Diagnostic::new(format!("there is no {word} here"), at)
            .label(format!("expected {}", listed(&known)));
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
        return Diagnostic::new("several keys say what this is", at).label("expected one key");
    }
    Diagnostic::new(message, at)
}

/// Returns the words with commas and an `or`.
pub(crate) fn listed(words: &[&str]) -> String {
    match words {
        [] => "nothing".to_owned(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}
