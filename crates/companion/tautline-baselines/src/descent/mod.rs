//! Other minimisers of a discrete energy between two points, beside the structured Newton method.
//!
//! Each takes a start, whose ends stay where they are, and goes down from there until the residual
//! of [`Iterate`](tautline::Iterate) is small. They show the same [`Iterate`](tautline::Iterate)s as
//! [`minimise_watched`](tautline::minimise_watched), so that a [`Trace`](tautline::Trace) compares
//! them. Nobody watches with `&mut |_| ControlFlow::Continue(())`.
//!
//! [`constrained_dynamic_programming`] confines the points to a surface `c(x) = 0`.
//!
//! The metric is one that is ready for batches, `Prepared::new(metric)`.
//!
//! ```
//! use std::{ops::ControlFlow, time::Instant};
//! use tautline::{PointSequence, Prepared, Rule, Trace, gallery::Valleys};
//! use tautline_baselines::descent::{Coordinates, Ended, Limits, lbfgs, sobolev_descent};
//!
//! let metric = Prepared::new(Valleys);
//! let start = PointSequence::straight([0.0, 0.0], [4.0, 1.0], 100)?;
//! let begun = Instant::now();
//! let mut clock = || begun.elapsed().as_secs_f64();
//! let mut trace = Trace::with_limit(&mut clock, 10.0);
//! let limits = Limits::default();
//! let one = sobolev_descent(&metric, Rule::TRAPEZOIDAL, start.clone(), &limits, &mut |iterate| {
//!     trace.record(iterate)
//! })?;
//! assert_eq!(one.ended, Ended::Stationary);
//! assert_eq!(trace.entries().len(), one.iterations + 1);
//!
//! let other = lbfgs(&metric, Rule::TRAPEZOIDAL, start, Coordinates::Points, &limits, &mut |_| {
//!     ControlFlow::Continue(())
//! })?;
//! assert!((one.energy / other.energy - 1.0).abs() < 1e-10);
//! assert!(other.iterations > 5 * one.iterations);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod chord_models;
mod constrained;
mod descended;
mod dynamic_programming;
mod laplacian;
mod lbfgs;
pub(crate) mod search;
mod sobolev;

pub use constrained::{Constrained, ConstrainedError, Equality, constrained_dynamic_programming};
pub use descended::{Descended, DescentError, Ended, Limits};
pub use dynamic_programming::{SecondOrder, dynamic_programming};
pub use lbfgs::{Coordinates, lbfgs};
pub use sobolev::sobolev_descent;
