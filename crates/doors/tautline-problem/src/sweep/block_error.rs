//! `BlockError`: why a text is no block of results.

/// Why a text is no block of results, or not a complete one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BlockError {
    /// It does not begin as results do.
    #[error("these are no results: line {line} does not begin with {expected:?}")]
    NoResults {
        /// The number of the line, from 1.
        line: usize,
        /// What was expected.
        expected: &'static str,
    },
    /// It ends before its end.
    #[error("the results are incomplete: they have no last line with a hash")]
    Incomplete,
    /// Its hash is not that of its lines.
    #[error("the results were changed: their hash is {written}, but the lines have {computed}")]
    Hash {
        /// The hash that is written.
        written: String,
        /// The hash that was computed.
        computed: String,
    },
    /// An id is not the next one.
    #[error("row {row} has the id {found:?}, not {expected}")]
    Id {
        /// The number of the row, from 1.
        row: u64,
        /// The id that was found; empty if there is no such row.
        found: String,
        /// The id that was expected.
        expected: String,
    },
}
