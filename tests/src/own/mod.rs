//! A metric, a rule and a closed set as a user writes them, using only the `tautline` crate.

mod ellipse;
mod metric;
mod rule;
mod set;

pub(crate) use ellipse::Ellipse;
