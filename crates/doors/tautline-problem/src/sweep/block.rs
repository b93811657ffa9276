//! `Block`: the results of consecutive problems.

use std::ops::Range;

use super::{BlockError, hash::Hash};

/// How each line of the head begins, in this order.
pub(crate) const TITLE: &str = "# tautline results 1";
pub(crate) const VERSION: &str = "# by tautline ";
pub(crate) const PLAN: &str = "# plan ";
pub(crate) const COUNT: &str = "# problems ";
pub(crate) const IDS: &str = "# ids ";
pub(crate) const COLUMNS: &str = "id,";
/// How the last line begins.
pub(crate) const END: &str = "# end ";

/// The head of a block of results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// The version of the program that computed them.
    pub version: String,
    /// The hash of the plan.
    pub plan: String,
    /// The number of problems of the plan.
    pub count: u64,
    /// The ids of the block.
    pub ids: Range<u64>,
    /// The names of the columns, with commas.
    pub columns: String,
}

impl Head {
    /// Returns the head as text, with a line break at its end.
    pub(crate) fn text(&self) -> String {
        let Self { version, plan, count, ids: Range { start, end }, columns } = self;
        format!(
            "{TITLE}\n{VERSION}{version}\n{PLAN}{plan}\n{COUNT}{count}\n{IDS}{start}..{end}\n{columns}\n"
        )
    }
}

/// The results of consecutive problems, complete and as they were written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block<'t> {
    /// What the block says of itself.
    pub head: Head,
    /// The rows, each with a line break.
    pub rows: &'t str,
}

impl<'t> Block<'t> {
    /// Reads a block. Its hash must be that of its lines, and its ids those of its head. A text from another
    /// system is to be made [`plain`](super::plain) first.
    ///
    /// # Errors
    ///
    /// [`BlockError`].
    pub fn read(text: &'t str) -> Result<Self, BlockError> {
        let (mut rest, mut number) = (text, 0);
        let mut after = |begin: &'static str| {
            number += 1;
            let (line, next) = rest.split_once('\n').unwrap_or((rest, ""));
            rest = next;
            let wrong = BlockError::NoResults { line: number, expected: begin };
            line.strip_prefix(begin).ok_or(wrong)
        };
        if !after(TITLE)?.is_empty() {
            return Err(BlockError::NoResults { line: 1, expected: TITLE });
        }
        let (version, plan) = (after(VERSION)?.to_owned(), after(PLAN)?.to_owned());
        let count = number_of(after(COUNT)?, 4, COUNT)?;
        let (start, end) =
            after(IDS)?.split_once("..").ok_or(BlockError::NoResults { line: 5, expected: IDS })?;
        let ids = number_of(start, 5, IDS)?..number_of(end, 5, IDS)?;
        if ids.start > ids.end || ids.end > count {
            return Err(BlockError::NoResults { line: 5, expected: IDS });
        }
        let columns = format!("{COLUMNS}{}", after(COLUMNS)?);
        let last = rest.strip_suffix('\n').ok_or(BlockError::Incomplete)?;
        let last = last.rfind('\n').map_or(0, |at| at + 1);
        let (rows, last) = rest.split_at(last);
        let written = last.trim_end().strip_prefix(END).ok_or(BlockError::Incomplete)?;
        let mut hash = Hash::default();
        hash.add(&text[..text.len() - last.len()]);
        let computed = hash.digits();
        if computed != written {
            return Err(BlockError::Hash { written: written.to_owned(), computed });
        }
        let mut lines = rows.lines();
        for (row, id) in (1..).zip(ids.clone().map(Some).chain([None])) {
            let found = lines.next().map(|line| line.split(',').next().unwrap_or_default());
            let expected = id.map(|id| id.to_string());
            if found != expected.as_deref() {
                let found = found.unwrap_or_default().to_owned();
                return Err(BlockError::Id { row, found, expected: expected.unwrap_or_default() });
            }
        }
        Ok(Self { head: Head { version, plan, count, ids, columns }, rows })
    }
}

fn number_of(text: &str, line: usize, expected: &'static str) -> Result<u64, BlockError> {
    text.parse().map_err(|_| BlockError::NoResults { line, expected })
}
