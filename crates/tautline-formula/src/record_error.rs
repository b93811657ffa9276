//! `RecordError`: why a metric has no recorded formula.

/// Why a metric is not one list of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// The formula asks whether two numbers are equal, or one is zero, where that depends on the
    /// point: it has branches.
    #[error("the formula compares numbers that depend on the point, so it has branches")]
    Compares,
    /// The formula is too long: every iteration of a loop is recorded.
    #[error("the formula has more than {most} steps")]
    TooLong {
        /// The most steps of a tape.
        most: usize,
    },
    /// The formula uses numbers of another evaluation, such as one on another thread.
    #[error("the formula uses numbers from another evaluation")]
    Foreign,
}
