//! Boxes and outlines, in px.

pub mod clip;
mod extent;
mod path;

pub use extent::Extent;
pub use path::{Path, Segment};
