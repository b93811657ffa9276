//! `RecordError`: why a metric has no recorded formula.

/// Why a metric is not a single list of operations, or why nothing is proved of it.
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
    /// Two entries of the matrix that mirror each other are not known to be equal. See
    /// [`Formula::unequal_halves`](crate::Formula::unequal_halves).
    #[error(
        "the entries ({}, {}) and ({}, {}) of the matrix are written in two ways, which are not known to be \
         equal: write both alike, or the entries on and above the diagonal alone",
        row + 1, column + 1, column + 1, row + 1
    )]
    Halves {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
    },
}
