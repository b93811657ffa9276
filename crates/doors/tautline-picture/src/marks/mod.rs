//! The contents of a panel: curves, fields, regions, notes and slope triangles, as data.

mod curve;
mod field;
mod gaps;
mod grid;
mod marker;
mod note;
mod region;
mod samples;
mod slope_triangle;

pub use curve::Curve;
pub use field::Field;
pub(crate) use gaps::Gaps;
pub use marker::Marker;
pub use note::Note;
pub use region::Region;
pub use samples::Samples;
pub use slope_triangle::SlopeTriangle;
