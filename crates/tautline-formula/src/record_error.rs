//! `RecordError`: why a metric has no recorded formula.

/// Why what a metric does cannot be written down as one list of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// The formula asks whether two numbers are equal, or whether one is zero, where that depends on the
    /// point: what it does then is one branch of several.
    #[error(
        "the formula compares numbers that depend on the point; a recorded one has no branches"
    )]
    Compares,
    /// The formula is too long: a loop writes down each of its rounds.
    #[error("the formula has more than {most} steps")]
    TooLong {
        /// The most steps of a tape.
        most: usize,
    },
    /// The formula uses numbers of another evaluation, such as one on another thread.
    #[error("the formula uses numbers that were made outside of this evaluation")]
    Foreign,
}
