//! `SplineError`: why an array is no spline.

use thiserror::Error;

/// A condition that a shape or its numbers violate.
///
/// Each variant carries the offending numbers, so that the message shows what to change. Axes and
/// positions are counted from 0.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SplineError {
    /// A spline has one, two or three axes.
    #[error("the shape {shape:?} has {} axes; a spline has 1, 2 or 3", shape.len())]
    Axes {
        /// The shape that was given.
        shape: Vec<usize>,
    },
    /// An axis needs at least one coefficient.
    #[error("axis {axis} of the shape {shape:?} has no coefficient")]
    EmptyAxis {
        /// The first axis of length 0.
        axis: usize,
        /// The shape that was given.
        shape: Vec<usize>,
    },
    /// The lengths of the axes have a product that does not fit in a `usize`.
    #[error("the shape {shape:?} has too many coefficients for any memory")]
    Overflow {
        /// The shape that was given.
        shape: Vec<usize>,
    },
    /// A monotone spline has too many coefficients, three for each sample along each axis.
    #[error(
        "an array of the shape {shape:?} has more than {most} coefficients as a monotone spline; as a cubic or a \
         smoothing one it has as many as numbers"
    )]
    TooFine {
        /// The shape that was given.
        shape: Vec<usize>,
        /// The most coefficients of all entries.
        most: usize,
    },
    /// There are as many numbers as the product of the lengths of the axes.
    #[error("the shape {shape:?} needs {expected} numbers, not {found}")]
    Count {
        /// The shape that was given.
        shape: Vec<usize>,
        /// The product of its lengths.
        expected: usize,
        /// The count of numbers that were given.
        found: usize,
    },
    /// Coefficients and samples are finite.
    #[error("the number at {index:?} is {value}, which is not finite")]
    NotFinite {
        /// The position along each axis.
        index: Vec<usize>,
        /// The number there.
        value: f64,
    },
    /// Coefficients and samples are at most `2¹⁰⁰⁰`, so that no derivative overflows.
    #[error("the number at {index:?} is {value:e}, beyond 2^1000 = 1.07e301")]
    TooLarge {
        /// The position along each axis.
        index: Vec<usize>,
        /// The number there: a coefficient or a sample.
        value: f64,
    },
}
