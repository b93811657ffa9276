//! `IntervalError`: invalid ends of an interval.

use thiserror::Error;

/// Why two numbers cannot be the ends of an interval.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum IntervalError {
    /// An end is NaN.
    #[error("the ends {lo} and {hi} must be numbers")]
    NotANumber {
        /// The lower end.
        lo: f64,
        /// The upper end.
        hi: f64,
    },
    /// The lower end lies above the upper one.
    #[error("the lower end {lo} lies above the upper end {hi}")]
    Inverted {
        /// The lower end.
        lo: f64,
        /// The upper end.
        hi: f64,
    },
    /// Both ends are `+∞`, or both are `−∞`.
    #[error("no real number lies between {lo} and {hi}")]
    NoRealNumber {
        /// The lower end.
        lo: f64,
        /// The upper end.
        hi: f64,
    },
}
