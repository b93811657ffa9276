//! Texts as other systems and editors save them.

use std::borrow::Cow;

/// Returns a text as it was written: with `\n` at the end of each line where another system has put
/// `\r\n`, and without the byte order mark that some editors put before it. Sweep files, plans and
/// results are read in this way.
///
/// ```
/// use tautline_problem::sweep::plain;
///
/// assert_eq!(plain("\u{feff}one\r\ntwo\r\n"), "one\ntwo\n");
/// ```
#[must_use]
pub fn plain(text: &str) -> Cow<'_, str> {
    let text = without_mark(text);
    if text.contains("\r\n") { text.replace("\r\n", "\n").into() } else { text.into() }
}

/// Returns a text without a byte order mark.
pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}
