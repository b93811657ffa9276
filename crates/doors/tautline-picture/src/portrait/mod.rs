//! The picture of one problem and its solution: the metric, the two ends and the curves.
//!
//! A [`Portrait`] is plain data without the dimension as a type, so that a command and a page can
//! both fill it in. It draws a [`Scene`], which is written as SVG, PNG or PDF; the same portrait
//! gives the same bytes.
//!
//! ```
//! use tautline_picture::{
//!     portrait::{Field, Portrait},
//!     svg,
//! };
//! use tautline_sets::{Ball, HalfSpace, Shape};
//!
//! // H(x) = (1 + x₁²) I, from a ball to the half-plane x₁ ≥ 2, that is −x₁ ≤ −2.
//! let gram = |x: &[f64]| {
//!     let phi = 1.0 + x[0] * x[0];
//!     Some(vec![phi, 0.0, 0.0, phi])
//! };
//! let ball = [Shape::Ball(Ball::from_slice(&[0.0, 0.0], 0.5)?)];
//! let wall = [Shape::HalfSpace(HalfSpace::from_slice(&[-1.0, 0.0], -2.0)?)];
//! let curve = [vec![0.5, 0.0], vec![2.0, 0.0]];
//! let portrait = Portrait {
//!     ends: [&ball, &wall],
//!     curve: &curve,
//!     field: Field::Determinant,
//!     ..Portrait::new(2, &gram)
//! };
//! let picture = svg(&portrait.draw()?);
//! assert!(picture.starts_with(b"<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
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
mod shadow;
mod span;
mod style;
mod window;

pub use corridor::{Corridor, Cubes};
pub use error::PortraitError;

use tautline_scalar::ANY;
use tautline_sets::Shape;

use crate::Scene;

/// How the metric is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Field {
    /// Not at all.
    Plain,
    /// As filled contours of `det H`; on a logarithmic scale if it is positive and spans decades.
    #[default]
    Determinant,
    /// As ellipses `{v : vᵀ H v = c}`, with the same `c` everywhere. In one dimension, where there
    /// are no ellipses, this is the same as `Determinant`.
    Ellipses,
}

/// One problem and its solution, as data.
///
/// In one dimension, the picture is a graph over time. In two, it is the plane; in more, it is the
/// plane of two [`coordinates`](Portrait::coordinates), to which curves and sets are projected.
/// There, the metric at a point of the picture is the one at the point of `R^D` whose coordinates
/// that are not drawn are means over the points of the curve, weighted by `1/distance⁴` in the
/// plane: on the curve, it is the metric that the curve sees.
///
/// The curve is solid, with a ring at its start and a disc at its end; other minima are dashed. The
/// start set is green and the end set is purple. A corridor is orange, and paler on coarser levels. Where `H` is not defined, the picture is hatched.
#[derive(Clone, Copy)]
pub struct Portrait<'a> {
    /// The dimension `D` of the space.
    pub dimension: usize,
    /// The Gram matrix `H(x)`, `D × D`, column by column; `None` where it is not defined. A matrix
    /// with an entry that is not finite counts as not defined.
    pub gram: &'a dyn Fn(&[f64]) -> Option<Vec<f64>>,
    /// The two ends. Each is the union of some sets.
    pub ends: [&'a [Shape<ANY>]; 2],
    /// The points of the solution, a polygon with the same time for each chord; empty if there is
    /// none.
    pub curve: &'a [Vec<f64>],
    /// Other local minima.
    pub others: &'a [Vec<Vec<f64>>],
    /// Cubes that hold every minimal geodesic, if that is proved. In one dimension, where they are an
    /// interval, only the bounds are shown.
    pub corridor: Option<Corridor<'a>>,
    /// The coordinates, counted from 0, that are drawn to the right and upwards; if not given, the
    /// two along which the curves extend farthest, in increasing order. In one dimension this has
    /// no effect.
    pub coordinates: Option<[usize; 2]>,
    /// How the metric is shown.
    pub field: Field,
    /// The part of the plane that is drawn: the range of each drawn coordinate. In one dimension
    /// only the first range counts. A window that is very flat or very tall is made rounder. If not
    /// given, it contains the curves and all sets that are not much larger.
    pub window: Option<[[f64; 2]; 2]>,
}

impl<'a> Portrait<'a> {
    /// Returns a portrait of a metric without sets and curves.
    #[must_use]
    pub fn new(dimension: usize, gram: &'a dyn Fn(&[f64]) -> Option<Vec<f64>>) -> Portrait<'a> {
        Portrait {
            dimension,
            gram,
            ends: [&[], &[]],
            curve: &[],
            others: &[],
            corridor: None,
            coordinates: None,
            field: Field::default(),
            window: None,
        }
    }

    /// Returns the coordinates that are drawn, counted from 0; `[0, 0]` in one dimension.
    ///
    /// # Errors
    ///
    /// If the data cannot be drawn, as for [`draw`](Portrait::draw).
    pub fn drawn_coordinates(&self) -> Result<[usize; 2], PortraitError> {
        checks::check(self)?;
        Ok(if self.dimension == 1 { [0, 0] } else { plane::coordinates(self) })
    }

    /// Draws the picture, 440 px wide. It is legible at a width of 85 mm.
    ///
    /// # Errors
    ///
    /// If a vector does not have `D` coordinates, if a number is not finite, if the window cannot
    /// be resolved in floating point, or if there is nothing to draw.
    pub fn draw(&self) -> Result<Scene, PortraitError> {
        checks::check(self)?;
        if self.dimension == 1 { over_time::draw(self) } else { plane::draw(self) }
    }

    /// Returns the pieces of each end, none of which is a union.
    pub(crate) fn pieces(&self) -> [Vec<&'a Shape<ANY>>; 2] {
        self.ends.map(|end| end.iter().flat_map(Shape::pieces).collect())
    }

    /// Returns the description for readers who cannot see the picture.
    pub(crate) fn title(&self, place: &str) -> String {
        let curve = if self.curve.is_empty() { "A metric" } else { "A minimal curve" };
        let field = match self.field {
            Field::Plain => "",
            Field::Determinant => ", over contours of det H",
            Field::Ellipses => ", over ellipses of H",
        };
        let others = match self.others.len() {
            0 => String::new(),
            1 => ", with another local minimum".to_owned(),
            n => format!(", with {n} other local minima"),
        };
        let corridor = match self.corridor {
            Some(_) => ", in the corridor of all minimal geodesics",
            None => "",
        };
        format!("{curve} {place}{field}{others}{corridor}")
    }
}
