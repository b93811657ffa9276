//! Writes new answers into a page.

use std::{fs, ops::Range, path::Path};

/// Replaces parts of the page, in order, in one step: an interrupted run leaves the old page.
pub(crate) fn rewrite(
    path: &Path,
    text: &str,
    edits: &[(Range<usize>, String)],
) -> Result<(), String> {
    let mut result = String::with_capacity(text.len());
    let mut at = 0;
    for (range, new) in edits {
        result.push_str(&text[at..range.start]);
        result.push_str(new);
        at = range.end;
    }
    result.push_str(&text[at..]);
    let fresh = path.with_extension("md.new");
    let done = fs::write(&fresh, result).and_then(|()| fs::rename(&fresh, path));
    done.map_err(|error| format!("{}: {error}", path.display()))
}
