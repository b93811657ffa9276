//! A block of code on a page.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A block of code.
#[derive(Debug)]
pub(crate) struct Block {
    /// The line of its opening fence, from 1.
    pub(crate) line: usize,
    /// What is to be done with it, or why that is unclear.
    pub(crate) kind: Result<Kind, String>,
    /// Its text.
    pub(crate) text: String,
    /// Where its text is on the page. Blocks in lists and quotations are indented there, so that
    /// the text may differ.
    pub(crate) range: Range<usize>,
}

/// What is to be done with a block.
#[derive(Debug, PartialEq)]
pub(crate) enum Kind {
    /// `console`: run the commands, and compare their answers.
    Console,
    /// `LANGUAGE,file=NAME`: write the file.
    File(String),
    /// `rust`: compiled and run as a documentation test of `tautline`.
    Rust,
    /// `LANGUAGE,ignore=REASON`: nothing.
    Ignored,
}

impl Kind {
    /// Reads the words after the opening fence.
    fn of(info: &str) -> Result<Self, String> {
        let (language, rest) = info.split_once(',').unwrap_or((info, ""));
        match (language, rest.split_once('=')) {
            ("", _) => Err("a block says its language".to_owned()),
            (_, Some(("file", name))) if is_plain(name) => Ok(Self::File(name.to_owned())),
            (_, Some(("file", name))) => Err(format!("{name:?} is no name of a file in a folder")),
            (_, Some(("ignore", reason))) if !reason.trim().is_empty() => Ok(Self::Ignored),
            (_, Some(("ignore", _))) => Err("`ignore=` needs a reason".to_owned()),
            ("console", _) if rest.is_empty() => Ok(Self::Console),
            ("rust", _) if rest.is_empty() => Ok(Self::Rust),
            _ => Err(format!(
                "`{info}` is checked by nothing: `console`, `rust` and `LANGUAGE,file=NAME` are, and \
                 `LANGUAGE,ignore=REASON` says why a block is not"
            )),
        }
    }
}

/// Returns whether `name` is a file in the folder itself.
fn is_plain(name: &str) -> bool {
    let allowed = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    !name.is_empty() && !name.starts_with('.') && name.chars().all(allowed)
}

/// Returns the blocks of a page, in order.
pub(crate) fn blocks(page: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    for (event, range) in Parser::new_ext(page, options).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                let kind = match kind {
                    CodeBlockKind::Fenced(info) => Kind::of(&info),
                    CodeBlockKind::Indented => Err("a block has a fence and a language".to_owned()),
                };
                let line = 1 + page[..range.start].matches('\n').count();
                blocks.push(Block { line, kind, text: String::new(), range: 0..0 });
                open = true;
            }
            Event::End(TagEnd::CodeBlock) => open = false,
            Event::Text(text) if open => {
                if let Some(block) = blocks.last_mut() {
                    let start = if block.text.is_empty() { range.start } else { block.range.start };
                    block.range = start..range.end;
                    block.text.push_str(&text);
                }
            }
            _ => {}
        }
    }
    blocks
}
