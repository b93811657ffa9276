//! Intervals: bounds on a formula over a whole box.
//!
//! The type is [`Enclosure`], with arithmetic, powers and functions. It is built on the operations
//! on doubles with directed rounding (`directed`), a number with an error bound (`approximation`),
//! Horner's scheme with an error bound (`series`), and one file for each elementary function. Every
//! error bound is derived where it is used, in units of `u = 2⁻⁵³`. Bounds on rounding errors are
//! at least a tenth larger than derived. This margin covers the higher-order terms in `u`, which
//! are less than `10⁻¹⁴` times the first-order term.

mod approximation;
mod arithmetic;
mod directed;
mod elementary;
mod enclosure;
mod fast;
mod functions;
#[cfg(test)]
mod high_precision;
mod interval_error;
mod kernel;
mod powers;
mod series;

pub use enclosure::{Enclosure, Interval};
pub use fast::{Fast, FastInterval};
pub use interval_error::IntervalError;
pub use kernel::{Kernel, Rigorous};
