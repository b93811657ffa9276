//! `Complaint`: why there is no answer, in words, and where in the formula.

use serde::Serialize;
use tautline::TextError;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Complaint {
    /// What is wrong, as a sentence without its full stop.
    pub message: String,
    /// Where the offending part of the formula starts, counted as JavaScript counts: in units of
    /// UTF-16. `None` if the formula can be read.
    pub start: Option<usize>,
    /// Where that part ends. At the end of the formula, it is empty.
    pub end: Option<usize>,
    /// What may help, as a sentence without its full stop.
    pub help: Option<String>,
}

impl Complaint {
    /// Says what is wrong with a formula, and where.
    #[must_use]
    pub fn about_text(formula: &str, error: &TextError) -> Self {
        let units = |byte: usize| formula.get(..byte).map(|text| text.encode_utf16().count());
        Self {
            message: error.problem.to_string(),
            start: units(error.at.start),
            end: units(error.at.end),
            help: error.help(formula.get(..error.at.start).unwrap_or_default(), &[]),
        }
    }

    /// Passes on an error that has no place in the formula.
    pub(crate) fn about(error: &impl ToString) -> Self {
        Self { message: error.to_string(), start: None, end: None, help: None }
    }
}

#[cfg(test)]
mod tests {
    use tautline::Formula;

    use super::Complaint;

    /// The sign before the unknown name takes two bytes and one unit, the one before that takes four
    /// bytes and two units.
    #[test]
    fn a_place_is_counted_as_javascript_counts() {
        let complaint = |text: &str| {
            let error = Formula::<2>::parse(text, &[]).expect_err("broken");
            Complaint::about_text(text, &error)
        };
        let Complaint { message, start, end, .. } = complaint("(2 - foo) I");
        assert_eq!((message.as_str(), start, end), ("unknown name foo", Some(5), Some(8)));
        let Complaint { start, end, .. } = complaint("(2 + 𝑥) I");
        assert_eq!((start, end), (Some(5), Some(7)));
        let Complaint { start, end, .. } = complaint("(2 + é) I");
        assert_eq!((start, end), (Some(5), Some(6)));
        let Complaint { start, end, .. } = complaint("(2 + x1");
        assert_eq!((start, end), (Some(7), Some(7)));
    }
}
