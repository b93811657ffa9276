//! Problems, curves, bounds and certificates in a dimension that is known when the program runs.
//!
//! Problem files, the command and Python stand on this crate, which is compiled once for all dimensions.
//! [`in_dimension`] lists those for which audits and the gallery are compiled.
//!
//! ```
//! use tautline::{Ball, HalfSpace};
//! use tautline_any::{Given, Request, Shape};
//!
//! let valleys = Given::parse("cost(2 - cos(x1))", 2, &[], &[])?;
//! let from = [Shape::Ball(Ball::from_slice(&[0.0, 0.0], 0.5)?)];
//! let to = [Shape::HalfSpace(HalfSpace::from_slice(&[-1.0, 0.0], -3.0)?)];
//! let curve = valleys.solve([&from, &to], &Request::default())?;
//! assert!((curve.length().value - 5.338305).abs() < 1e-6); // 5 − sin 3 + sin ½
//! assert_eq!(curve.points().len(), 257 * 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod bounds;
mod certified;
mod constants;
mod curve;
mod dimension;
mod ends;
mod float;
mod given;
mod given_error;
mod least_entry;
mod proofs;
mod region;

pub use answer::{
    Answer, BallAnswer, Bounds, CertificateAnswer, DoubtAnswer, Estimated, GlobalMinimum,
    OtherMinimum, Search, UsedConstants,
};
pub use bounds::Proving;
pub use certified::{CertifiedAnswer, LevelAnswer};
pub use constants::{ConstantAnswer, ConstantsAnswer, ConstantsError, IF_IT_SETTLES, constants};
pub use curve::{Curve, Observe};
pub use dimension::{
    InDimension, LARGEST_DIMENSION, LARGEST_EXPANSION, LARGEST_FIXED_DIMENSION,
    LARGEST_PROVED_DIMENSION, in_dimension,
};
pub use ends::{ends, vector};
pub use float::Float;
pub use given::{Found, Given};
pub use given_error::GivenError;
pub use least_entry::{Least, least_at, least_entry};
pub use proofs::{ACCURACY, Proofs, default_boxes};
pub use region::{Region, distance, factor};

pub use tautline::{
    CHORDS, Doubt, Grid, LEAST_TOLERANCE, Nodes, Request, RequestError, TextError, Values,
};

/// A set in a dimension that is known when the program runs.
pub type Shape = tautline::Shape<{ tautline::ANY }>;

/// A computed line in a dimension that is known when the program runs.
pub type Line = tautline::TautLine<tautline::Known, { tautline::ANY }>;
