//! Publication-quality figures: one drawing, written as SVG, PNG and PDF.
//!
//! A [`Figure`] consists of [`Panel`]s, and a panel consists of two axes and data. plotters turns
//! the data into shapes, and our own backend records them in a [`Scene`]. Three writers write this
//! one scene, so the three files cannot disagree. Nothing in them depends on a system font, a clock
//! or an address: two runs give the same bytes. A [`Portrait`](portrait::Portrait) is the picture of one
//! problem and its solution.
//!
//! ```
//! use tautline_picture::{Axis, Curve, Figure, Marker, Panel, Scale, palette, pdf, png, svg};
//!
//! let points: Vec<(f64, f64)> = (0..=6).map(|k| 2.0_f64.powi(k)).map(|n| (n, 0.3 / n / n)).collect();
//! let x = Axis::new(Scale::Octaves, 1.0, 64.0)?.labelled("number of subintervals $N$");
//! let y = Axis::decades_covering(points.iter().map(|p| p.1), f64::INFINITY)?
//!     .labelled("excess energy $E(γ^\"pl\") - d^2$");
//! let curve = Curve::new(points, palette::BLUE).marked(Marker::Disc).labelled("observed");
//! let scene = Figure::new(480.0, "Excess energy", vec![vec![Panel::new(x, y).curve(curve)]]).draw()?;
//! let files = [svg(&scene), png(&scene)?, pdf(&scene)];
//! assert!(files.iter().all(|bytes| !bytes.is_empty()));
//! # Ok::<(), tautline_picture::DrawingError>(())
//! ```

mod axes;
mod colours;
mod error;
mod geometry;
mod marks;
pub mod math_text;
mod measures;
mod panels;
mod picture;
pub mod portrait;

pub use axes::{Axis, Scale};
pub use colours::{Colour, Ramp, palette};
pub use error::DrawingError;
pub use geometry::{Extent, Path, Segment, clip};
pub use marks::{Curve, Field, Marker, Note, Region, Samples, SlopeTriangle};
pub use math_text::Align;
pub use panels::{Figure, Panel};
pub use picture::{Paint, Scene, Shape, Stroke, pdf, png, svg};
