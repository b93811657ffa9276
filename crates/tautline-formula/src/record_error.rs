//! `RecordError`: why a metric has no recorded formula.

/// Why a metric is not a single list of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// The formula asks whether two numbers are equal, or whether one is zero, and the answer
    /// depends on the point. It therefore has branches.
    #[error("the formula compares numbers that depend on the point, so it has branches")]
    Compares,
    /// The formula is too long. Every iteration of a loop is recorded.
    #[error("the formula has more than {most} steps")]
    TooLong {
        /// The largest number of steps of a tape.
        most: usize,
    },
    /// The formula uses numbers of another evaluation, such as one on another thread.
    #[error("the formula uses numbers from another evaluation")]
    Foreign,
    /// The metric is a [`BlackBox`](crate::BlackBox).
    #[error("the metric is known by its values only, not by a formula")]
    BlackBox,
}
