//! `TextError`: what is wrong with a text, and where.

use std::ops::Range;

use crate::RecordError;

/// What is wrong with a text, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("at byte {}: {problem}", .at.start)]
pub struct TextError {
    /// The offending bytes; the range is empty at the end of the text.
    pub at: Range<usize>,
    /// What is wrong.
    pub problem: Problem,
}

/// What is wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// An unexpected word.
    #[error("found {found}, expected {expected}")]
    Unexpected {
        /// The word, or `the end`.
        found: String,
        /// What was expected.
        expected: &'static str,
    },
    /// An unknown name.
    #[error("unknown name {name}")]
    UnknownName {
        /// The name.
        name: String,
    },
    /// A coordinate beyond the dimension.
    #[error("there is no {name} in dimension {dimension}")]
    NoCoordinate {
        /// Its name.
        name: String,
        /// The number of coordinates.
        dimension: usize,
    },
    /// An unknown function.
    #[error("unknown function {name}")]
    UnknownFunction {
        /// Its name.
        name: String,
    },
    /// A name that is already taken.
    #[error("{name} is already defined")]
    TakenName {
        /// The name.
        name: String,
    },
    /// An exponent that is not an integer of 32 bits.
    #[error("an exponent must be an integer from {} to {}", i32::MIN, i32::MAX)]
    Exponent,
    /// A number beyond the range of `f64`: too large, or so small that it would become 0.
    #[error("a number beyond the range of f64")]
    TooLarge,
    /// Arithmetic with a number that is infinite or undefined, such as `1/0`.
    #[error("there is no arithmetic with {number}")]
    NotFinite {
        /// The number.
        number: String,
    },
    /// A matrix that is not `D × D`.
    #[error("{found} {what} in dimension {dimension}")]
    Shape {
        /// How many there are.
        found: usize,
        /// What is counted: rows, or entries of a row.
        what: &'static str,
        /// How many there must be.
        dimension: usize,
    },
    /// A form with too few or too many functions.
    #[error("{form} takes {takes} in dimension {dimension}, found {found}")]
    Functions {
        /// The name of the form.
        form: &'static str,
        /// How many it takes.
        takes: String,
        /// How many there are.
        found: usize,
        /// The number of coordinates.
        dimension: usize,
    },
    /// A table with too few or too many arguments.
    #[error("{name} takes {takes} arguments, found {found}")]
    Arguments {
        /// The name of the table.
        name: String,
        /// How many it takes.
        takes: usize,
        /// How many there are.
        found: usize,
    },
    /// Brackets nested too deeply.
    #[error("more than {most} levels of brackets")]
    TooDeep {
        /// The largest number of levels.
        most: usize,
    },
    /// The formula cannot be recorded.
    #[error(transparent)]
    Record(#[from] RecordError),
}
