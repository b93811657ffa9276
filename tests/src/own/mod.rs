//! What a user brings: a metric, a rule, a closed set, each written against the face alone.

mod ellipse;
mod metric;
mod rule;
mod set;

pub(crate) use ellipse::Ellipse;
