//! Axes: scales, ranges, ticks and their numbers.

mod axis;
mod coordinate;
mod scale;
mod stretch;
mod tick;
mod tick_values;

pub use axis::Axis;
pub use scale::Scale;
pub(crate) use stretch::Stretch;
pub(crate) use tick::{Direction, Tick, named_ticks, ticks, ticks_at};
