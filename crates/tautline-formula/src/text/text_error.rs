//! `TextError`: what is wrong with a formula that was typed, and where.

use std::ops::Range;

use crate::RecordError;

/// What is wrong with a text, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("at byte {}: {problem}", .at.start)]
pub struct TextError {
    /// Which bytes of the text are wrong; empty at the end of the text.
    pub at: Range<usize>,
    /// What is wrong with them.
    pub problem: Problem,
}

/// What is wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// Something else has to stand there.
    #[error("found {found}, expected {expected}")]
    Unexpected {
        /// What stands there, as text; `the end` behind the last byte.
        found: String,
        /// What may stand there.
        expected: &'static str,
    },
    /// A name that nobody has given.
    #[error("nothing is called {name}")]
    UnknownName {
        /// The name.
        name: String,
    },
    /// A coordinate that there is not.
    #[error("there is no {name} in dimension {dimension}")]
    NoCoordinate {
        /// Its name.
        name: String,
        /// How many there are.
        dimension: usize,
    },
    /// A function that there is not.
    #[error("there is no function {name}")]
    UnknownFunction {
        /// Its name.
        name: String,
    },
    /// A name that has a meaning already.
    #[error("{name} has a meaning already")]
    TakenName {
        /// The name.
        name: String,
    },
    /// An exponent that is no whole number of 32 bits.
    #[error("an exponent is a whole number from {} to {}", i32::MIN, i32::MAX)]
    Exponent,
    /// A number beyond the range of `f64`.
    #[error("a number beyond the range of f64")]
    TooLarge,
    /// A matrix of another shape than `D × D`.
    #[error("{found} {what} in dimension {dimension}")]
    Shape {
        /// How many there are.
        found: usize,
        /// Rows or entries of a row.
        what: &'static str,
        /// How many there have to be.
        dimension: usize,
    },
    /// A form of too few functions, or too many.
    #[error("{form} takes {takes} in dimension {dimension}, and here is {found}")]
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
    /// Brackets within brackets, deeper than anybody writes.
    #[error("more than {most} levels of brackets")]
    TooDeep {
        /// The most levels.
        most: usize,
    },
    /// The formula cannot be recorded.
    #[error(transparent)]
    Record(#[from] RecordError),
}
