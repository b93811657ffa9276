//! The finished picture: shapes recorded from plotters, written as SVG, PNG and PDF.

mod pdf;
mod png;
mod recorder;
mod scene;
mod svg;

pub use pdf::pdf;
pub use png::png;
pub(crate) use recorder::{Recorder, UNITS, units};
pub use scene::{Paint, Scene, Shape, Stroke};
pub use svg::svg;
