//! Intervals: a formula evaluated at all points of a box at once.

mod approximation;
mod arctangent;
mod arithmetic;
mod circular;
mod constants;
mod directed;
mod enclosure;
mod even_odd;
mod exponential;
mod fast;
mod functions;
mod hyperbolic;
mod interval_error;
mod kernel;
mod logarithm;
mod powers;
mod quarter_turns;
mod series;

pub use enclosure::{Enclosure, Interval};
pub use fast::{Fast, FastInterval};
pub use interval_error::IntervalError;
pub use kernel::{Kernel, Rigorous};
