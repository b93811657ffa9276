//! Writes above a block of code the name of its file, or why the tests do not run it.

use mdbook_preprocessor::{Preprocessor, PreprocessorContext, book::Book, errors::Result};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};

use crate::page;

/// The preprocessor.
pub(crate) struct Captions;

impl Preprocessor for Captions {
    fn name(&self) -> &str {
        "captions"
    }

    fn run(&self, _: &PreprocessorContext, book: Book) -> Result<Book> {
        page::each_page(book, |text| Ok(with_captions(text)))
    }
}

/// Returns the page with captions, and with the language alone after each opening fence.
fn with_captions(text: &str) -> String {
    let mut edits = Vec::new();
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) = event else { continue };
        let Some((language, rest)) = info.split_once(',') else { continue };
        let caption = match rest.split_once('=') {
            Some(("file", name)) => escaped(name),
            Some(("ignore", reason)) => format!("<em>Not run here: {}.</em>", escaped(reason)),
            _ => continue,
        };
        let line = range.start..range.start + text[range.clone()].find('\n').unwrap_or(0);
        let fence = text[line.clone()].trim_end_matches(&*info);
        let new = format!("<div class=\"caption\">{caption}</div>\n\n{fence}{language}");
        edits.push((line, new));
    }
    page::replaced(text, edits)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::with_captions;

    #[test]
    fn files_and_reasons_are_written_above_their_blocks() {
        let text = "A\n\n```toml,file=a.toml\nx = 1\n```\n\n```julia,ignore=needs Julia\nx\n```\n";
        let new = "A\n\n<div class=\"caption\">a.toml</div>\n\n```toml\nx = 1\n```\n\n\
                   <div class=\"caption\"><em>Not run here: needs Julia.</em></div>\n\n```julia\nx\n```\n";
        assert_eq!(with_captions(text), new);
    }

    #[test]
    fn other_blocks_are_left_alone() {
        let text = "```rust\nx\n```\n\n```console\n$ x\n```\n\n    indented, file=x\n";
        assert_eq!(with_captions(text), text);
    }
}
