//! `MergeError`: why blocks are not one table.

use std::{fmt, ops::Range};

/// Why blocks are not the results of one plan with every problem once.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// There are no blocks.
    #[error("there are no results to merge")]
    Nothing,
    /// A block is of another plan, or of another version.
    #[error("{}", self.message(of_block))]
    Other {
        /// The number of the block, from 1, in the order given.
        index: usize,
        /// What differs.
        what: &'static str,
        /// What this block has.
        found: String,
        /// What the first block has.
        expected: String,
    },
    /// Problems are missing or occur twice.
    #[error("{}", self.message(of_block))]
    NotOnce {
        /// The ids that are missing.
        missing: Vec<Range<u64>>,
        /// The ids that occur twice, with the numbers of the blocks, from 1.
        doubled: Vec<(Range<u64>, [usize; 2])>,
    },
}

/// How many ranges are listed.
const LISTED: usize = 20;

impl MergeError {
    /// Returns the message, in which `name` is what a block is called, given its number from 1.
    pub fn message(&self, name: impl Fn(usize) -> String) -> String {
        let (missing, doubled) = match self {
            MergeError::Nothing => return "there are no results to merge".to_owned(),
            MergeError::Other { index, what, found, expected } => {
                let (this, first) = (name(*index), name(1));
                return format!("{this} has the {what} {found}, but {first} has {expected}");
            }
            MergeError::NotOnce { missing, doubled } => (missing, doubled),
        };
        let missing = missing.iter().map(|ids| format!("ids {} are missing", Shown(ids)));
        let doubled = doubled.iter().map(|(ids, [a, b])| {
            format!("ids {} are both in {} and in {}", Shown(ids), name(*a), name(*b))
        });
        let lines: Vec<String> = missing.chain(doubled).collect();
        let (listed, more) = lines.split_at(lines.len().min(LISTED));
        let more = match more.len() {
            0 => String::new(),
            more => format!("\nand {more} more such ranges"),
        };
        listed.join("\n") + &more
    }
}

fn of_block(index: usize) -> String {
    format!("block {index}")
}

/// Ids, with the last one.
struct Shown<'r>(&'r Range<u64>);

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {}", self.0.start, self.0.end.saturating_sub(1))
    }
}
