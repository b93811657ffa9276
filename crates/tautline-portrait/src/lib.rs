//! The picture of one problem and its solution: the metric, the two ends and the curves.
//!
//! A [`Portrait`] is plain data without the dimension as a type, so that a command and a page can
//! both fill it in. It draws a [`Scene`], which is written as SVG, PNG or PDF; the same portrait
//! gives the same bytes.
//!
//! ```
//! use tautline_portrait::{Field, Portrait, Shape, svg};
//!
//! // H(x) = (1 + x₁²) I, from a ball to the half-plane x₁ ≥ 2, that is −x₁ ≤ −2.
//! let gram = |x: &[f64]| {
//!     let phi = 1.0 + x[0] * x[0];
//!     Some(vec![phi, 0.0, 0.0, phi])
//! };
//! let ball = [Shape::Ball { centre: vec![0.0, 0.0], radius: 0.5 }];
//! let wall = [Shape::HalfSpace { normal: vec![-1.0, 0.0], offset: -2.0 }];
//! let curve = [vec![0.5, 0.0], vec![2.0, 0.0]];
//! let portrait = Portrait {
//!     ends: [&ball, &wall],
//!     curve: &curve,
//!     field: Field::Determinant,
//!     ..Portrait::new(2, &gram)
//! };
//! let picture = svg(&portrait.draw()?);
//! assert!(picture.starts_with(b"<svg"));
//! # Ok::<(), tautline_portrait::PortraitError>(())
//! ```

mod background;
mod checks;
mod corridor;
mod determinant;
mod ellipses;
mod error;
mod gram;
mod levels;
mod lift;
mod over_time;
mod plane;
mod portrait;
mod shadow;
mod shape;
mod span;
mod style;
mod window;

pub use corridor::{Corridor, Cubes};
pub use error::PortraitError;
pub use portrait::{Field, Portrait};
pub use shape::Shape;
pub use tautline_drawing::{Scene, pdf, png, svg};
