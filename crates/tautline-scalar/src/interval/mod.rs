//! Intervals: a formula evaluated at all points of a box at once.
//!
//! One object a file: the type ([`Enclosure`]), its arithmetic, powers and functions; below them
//! the operations of doubles rounded in a direction (`directed`), a number with a bound of its
//! error (`approximation`), Horner's scheme with a bound of its error (`series`), and an elementary
//! function each. Every bound is derived where it is used, in units of `u = 2⁻⁵³`, and is taken
//! larger than derived, by a tenth or more where rounding is concerned. The higher orders of `u`,
//! less than `10⁻¹⁴` of the first, go into that margin.

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
