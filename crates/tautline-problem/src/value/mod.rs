//! Problems as values: metrics and sets that a program gives, not a file, in a dimension that is known
//! when the program runs.
//!
//! ```
//! use tautline::{Ball, HalfSpace};
//! use tautline_problem::value::{Given, Request, Shape};
//!
//! let valleys = Given::parse("cost(2 - cos(x1))", 2, &[], &[])?;
//! let from = [Shape::Ball(Ball::from_slice(&[0.0, 0.0], 0.5)?)];
//! let to = [Shape::HalfSpace(HalfSpace::from_slice(&[-1.0, 0.0], -3.0)?)];
//! let curve = valleys.solve([&from, &to], &Request::default())?;
//! assert!((curve.length().value - 5.338305).abs() < 1e-6); // 5 − sin 3 + sin ½
//! assert_eq!(curve.points().len(), 257 * 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod avoiding;
mod curve;
mod given;
mod given_error;
mod request;

pub use avoiding::Region;
pub use curve::{Curve, Observe};
pub use given::{Found, Given, Least};
pub use given_error::GivenError;
pub use request::{Nodes, Proofs, Request};

pub use crate::Grid;
pub use tautline::{TextError, Values};

/// A set in a dimension that is known when the program runs.
pub type Shape = tautline::Shape<{ tautline::ANY }>;
