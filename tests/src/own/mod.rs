//! A metric, a rule and a closed set as a user writes them, against the `tautline` crate alone.

mod ellipse;
mod metric;
mod rule;
mod set;

pub(crate) use ellipse::Ellipse;
