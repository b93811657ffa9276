//! The number types in which one formula is evaluated.
//!
//! A metric is written once, generic over [`Scalar`]. Evaluated in `f64` it gives values,
//! in [`Jet1`] values and gradients, in [`Jet2`] values, gradients and second derivatives:
//! exact up to rounding, and nobody differentiates by hand. In many variables [`MixedJet`] gives
//! the second derivatives block by block.
//!
//! ```
//! use tautline_scalar::{Jet2, Scalar};
//!
//! fn valley<S: Scalar>(x: S) -> S {
//!     (-x.cos() + 2.0).sqr()
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
//! `+ − × ÷` between scalars and with an `f64` on the right, and the methods of [`Scalar`].
//! There is no ordering, no absolute value and no branching on purpose: a formula that
//! compiles is smooth wherever it is defined, and a number type that stands for a whole
//! range of values (an interval) can evaluate it too. The jets are generic over the number
//! they are built on for the same reason.
//!
//! A decimal in a formula means the `f64` nearest to it. `2.0 - x` cannot be written for a
//! type of our own; write `-x + 2.0`.

mod float;
mod interval;
mod jet1;
mod jet2;
mod mixed_jet;
mod operators;
mod scalar;

pub use interval::{Enclosure, Fast, FastInterval, Interval, IntervalError, Kernel, Rigorous};
pub use jet1::Jet1;
pub use jet2::Jet2;
pub use mixed_jet::MixedJet;
pub use scalar::Scalar;
