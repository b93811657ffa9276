//! Edits of the Markdown of a page.

use std::ops::Range;

use mdbook_preprocessor::{
    book::{Book, Chapter},
    errors::{Error, Result},
};

/// Replaces parts of `text`, which must be in order and apart.
pub(crate) fn replaced(text: &str, edits: Vec<(Range<usize>, String)>) -> String {
    let mut result = String::with_capacity(text.len());
    let mut at = 0;
    for (range, new) in edits {
        result.push_str(&text[at..range.start]);
        result.push_str(&new);
        at = range.end;
    }
    result.push_str(&text[at..]);
    result
}

/// Applies `edit` to the text of every chapter. An error names the page, and the line of the byte
/// that comes with it.
pub(crate) fn each_page(
    mut book: Book,
    edit: impl Fn(&str) -> Result<String, (usize, String)>,
) -> Result<Book> {
    let mut failed = Vec::new();
    book.for_each_chapter_mut(|chapter: &mut Chapter| match edit(&chapter.content) {
        Ok(text) => chapter.content = text,
        Err((at, why)) => {
            let line = 1 + chapter.content[..at].matches('\n').count();
            let name = chapter.source_path.as_deref().unwrap_or("?".as_ref()).display();
            failed.push(format!("{name}:{line}: {why}"));
        }
    });
    if failed.is_empty() { Ok(book) } else { Err(Error::msg(failed.join("\n"))) }
}
