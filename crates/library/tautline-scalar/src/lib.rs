//! Number types in which one formula is evaluated: floats, jets and intervals.
//!
//! A metric is written once, generic over [`Scalar`]. Evaluation in `f64` gives values. Evaluation
//! in [`Jet1`] also gives gradients, and in [`Jet2`] also second derivatives. They are exact up to
//! rounding, and nothing has to be differentiated by hand.
//!
//! ```
//! use tautline_scalar::{Jet2, Scalar};
//!
//! fn valley<S: Scalar>(x: S) -> S {
//!     (2.0 - x.cos()).sqr()
//! }
//!
//! assert_eq!(valley(0.0), 1.0);
//! // One variable, at x = π/2: f² = 4, (f²)' = 2 f f' = 4, (f²)'' = 2 f'² + 2 f f'' = 2.
//! let [x] = Jet2::variables(&[std::f64::consts::FRAC_PI_2]);
//! let y = valley(x);
//! assert!((y.value() - 4.0).abs() < 1e-15);
//! assert!((y.first(0) - 4.0).abs() < 1e-15);
//! assert!((y.second(0, 0) - 2.0).abs() < 1e-14);
//! ```
//!
//! # What a formula may use
//!
//! A formula may use `+ − × ÷` between scalars and with an `f64` on either side, and the methods of
//! [`Scalar`]. There is deliberately no order, no absolute value and no branching. A formula that
//! compiles is therefore smooth wherever it is defined, and intervals can evaluate it. For the same
//! reason jets are generic in the number type of their coefficients.
//!
//! A decimal in a formula means the `f64` nearest to it.
//!
//! # Two at a time
//!
//! A [`Pair`] is two `f64` in one vector register. `Jet2<Pair, D>` expands a formula at two points
//! at once.
//!
//! # Intervals
//!
//! Evaluated in [`Interval`], a formula gives bounds on its values over a box. Evaluated in
//! `Jet2<Interval, D>`, it also gives bounds on its derivatives.
//!
//! ```
//! use tautline_scalar::{Interval, Jet1, Scalar};
//!
//! // The slope of (2 − cos x)² is 2 (2 − cos x) sin x: at most 6 in absolute value.
//! let [x] = Jet1::variables(&[Interval::new(0.0, 3.0).expect("ordered")]);
//! let slope = (2.0 - x.cos()).sqr().first(0);
//! assert!(slope.lo() <= 0.0 && 3.5 < slope.hi() && slope.hi() < 6.001);
//!
//! // Undefined at one point of the range: no finite bound, whatever comes after.
//! let x = Interval::new(-1.0, 1.0).expect("ordered");
//! assert!(x.recip().atan().is_undefined());
//! # Ok::<(), tautline_scalar::IntervalError>(())
//! ```
//!
//! # Trust base
//!
//! The enclosures of an [`Interval`] are valid if all of this holds:
//!
//! * `+ − × ÷ √` of `f64` round to nearest, ties to even, with gradual underflow, as IEEE 754 and
//!   the Rust reference demand. There are no fused or reordered operations and no flushing of
//!   subnormals, and no foreign code in the process sets another rounding mode.
//! * The compiler and the processor are correct, and the compiler evaluates constant quotients
//!   (`1/3!`) as the processor would.
//! * The derivations in the comments of the kernel are correct. The tests also compare the kernel
//!   with `astro-float` at 192 bits: twenty thousand arguments of each function in every run, and a
//!   million in the example `enclosures_by_the_million`. The example `formulas_by_the_million`
//!   compares random formulas with their jets, and `metrics_by_the_million` of `tautline-certify`
//!   the metrics of the gallery. A test is no proof.
//! * The constants `π/2`, `ln 2` and the arctangents of eighths have the stated errors. A test
//!   compares each with a computation at 320 bits.
//! * The formula is the intended one, decimals included.
//!
//! No mathematical library is trusted. A [`FastInterval`] additionally relies on the functions of
//! `pxfm` never being off by more than one unit in the last place.

mod any;
pub mod decimal;
pub mod elementary;
#[cfg(test)]
mod exact_decimal;
mod f64_on_the_left;
mod float;
mod interval;
mod jet1;
mod jet2;
mod lanes;
mod operators;
mod pair;
mod scalar;
mod short;
mod table;

pub use any::ANY;
pub use interval::{Enclosure, Fast, FastInterval, Interval, IntervalError, Kernel, Rigorous};
pub use jet1::Jet1;
pub use jet2::Jet2;
pub use lanes::Lanes;
pub use pair::Pair;
pub use scalar::Scalar;
pub use short::Short;
pub use table::Table;

#[doc(hidden)]
pub use num_traits;
