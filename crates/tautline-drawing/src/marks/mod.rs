//! The contents of a panel: curves, fields, notes and slope triangles, as data.

mod curve;
mod field;
mod marker;
mod note;
mod slope_triangle;

pub use curve::Curve;
pub use field::Field;
pub use marker::Marker;
pub use note::Note;
pub use slope_triangle::SlopeTriangle;
