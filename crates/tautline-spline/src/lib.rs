//! Arrays of numbers as functions with continuous second derivatives, and proved ranges of all
//! their derivatives.
//!
//! A cost that was measured or drawn is an array, not a formula. A [`Spline`] makes it a function
//! on all of `R^E`, for one to three axes:
//!
//! ```text
//! f(u) = Σ c_{ijk} B(u₁ − i) B(u₂ − j) B(u₃ − k)
//! ```
//!
//! with the cubic B-spline `B` of support `(−2, 2)`, which is `2/3` at `0`, `1/6` at `±1`, and
//! twice continuously differentiable. Coordinates are in units of the grid: node `i` lies at
//! `u = i`. Outside of the array the nearest coefficient is repeated, so an axis with `n`
//! coefficients has no border: the function is constant along it for `u ≤ −1` and for `u ≥ n`.
//!
//! ```
//! use tautline_scalar::Interval;
//! use tautline_spline::Spline;
//!
//! // Two rows of three pixels. The last axis is the fastest one, as in NumPy.
//! let cost = Spline::new(&[2, 3], vec![1.0, 4.0, 2.0, 1.0, 8.0, 2.0])?;
//! assert_eq!(cost.value(&[-5.0, f64::INFINITY], [0, 0, 0]), 2.0);
//!
//! // The slope along the second axis, at a point and bounded over a box.
//! let slope = cost.value(&[0.5, 1.25], [0, 1, 0]);
//! let side = Interval::new(0.25, 1.5)?;
//! let slopes = cost.enclosure(&[side, side], [0, 1, 0]);
//! assert!(slopes.contains(slope));
//!
//! // Values on all of space lie between the coefficients.
//! assert_eq!(cost.range([0, 0, 0]), Interval::new(1.0, 8.0)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which coefficients
//!
//! | | [`Spline::new`] with the samples | [`Spline::interpolating`] |
//! | --- | --- | --- |
//! | value at a node | a mean of the samples there and next to it | the sample |
//! | between nodes | between the nearest samples: positive and monotone where they are | may overshoot |
//! | constants and linear functions | reproduced | reproduced away from the border |
//! | quadratic and cubic functions | smoothed | reproduced away from the border |
//!
//! A cost must be positive. If it interpolates samples, look at [`Spline::range`] first.
//!
//! # Proofs
//!
//! The derivative of order `a` along an axis is a spline of degree `3 − a`, whose coefficients are
//! the `a`-th differences of `c`. It is a convex combination of those that meet a cell, and, on a
//! part of a cell, of its Bernstein coefficients there. [`Spline::enclosure`] computes these with a
//! bound on rounding. It relies on what the intervals of `tautline-scalar` rely on: `+ − × ÷` of
//! `f64` round to nearest.

mod basis;
mod enclosure;
mod expansion;
mod interpolation;
mod place;
mod pyramid;
mod spline;
mod spline_error;
mod stencil;
mod table;
mod value;

pub use expansion::Expansion;
pub use spline::Spline;
pub use spline_error::SplineError;
