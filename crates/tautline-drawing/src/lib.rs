//! Publication-quality figures: one drawing, written as SVG, PNG and PDF.
//!
//! A [`Figure`] is made of [`Panel`]s, a panel of two axes and data. Drawing it goes through
//! plotters, which turns data into shapes; our own backend records them in a [`Scene`], and the
//! three writers spell that one scene out. So the three files cannot disagree, and since nothing
//! in them depends on a system font, a clock or an address, two runs give the same bytes.
//!
//! ```
//! use tautline_drawing::{Axis, Curve, Figure, Marker, Panel, Scale, palette, pdf, png, svg};
//!
//! let points: Vec<(f64, f64)> = (0..=6).map(|k| 2.0_f64.powi(k)).map(|n| (n, 0.3 / n / n)).collect();
//! let x = Axis::new(Scale::Octaves, 1.0, 64.0)?.labelled("number of subintervals $N$");
//! let y = Axis::decades_covering(points.iter().map(|p| p.1), f64::INFINITY)?
//!     .labelled("excess energy $E(γ^\"pl\") - d^2$");
//! let curve = Curve::new(points, palette::BLUE).marked(Marker::Disc).labelled("observed");
//! let scene = Figure::new(480.0, "Excess energy", vec![vec![Panel::new(x, y).curve(curve)]]).draw()?;
//! let files = [svg(&scene), png(&scene)?, pdf(&scene)];
//! assert!(files.iter().all(|bytes| !bytes.is_empty()));
//! # Ok::<(), tautline_drawing::DrawingError>(())
//! ```

mod axis;
mod backend;
mod colour;
mod colour_bar;
mod curve;
mod end_label;
mod error;
mod extent;
mod field;
mod figure;
mod font;
mod formula;
mod frame;
mod key;
mod marker;
pub mod math_text;
mod measures;
mod note;
pub mod palette;
mod panel;
mod path;
mod pdf;
mod plot;
mod png;
mod push_apart;
mod ramp;
mod remark;
mod scene;
mod slope_triangle;
mod stretch;
mod svg;
mod tick;

pub use axis::{Axis, Scale};
pub use colour::Colour;
pub use curve::Curve;
pub use error::DrawingError;
pub use extent::Extent;
pub use field::Field;
pub use figure::Figure;
pub use marker::Marker;
pub use math_text::Align;
pub use note::Note;
pub use panel::Panel;
pub use path::{Path, Segment};
pub use pdf::pdf;
pub use png::png;
pub use ramp::Ramp;
pub use scene::{Paint, Scene, Shape, Stroke};
pub use slope_triangle::SlopeTriangle;
pub use stretch::Stretch;
pub use svg::svg;
