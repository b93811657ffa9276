//! Boxes and outlines, in px.

mod extent;
mod path;

pub use extent::Extent;
pub use path::{Path, Segment};
