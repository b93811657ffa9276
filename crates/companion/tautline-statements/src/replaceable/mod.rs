//! What a mutant can replace in the library: entries of the table of bounds, and programs.

mod asked;
mod bounds;
mod program;

pub use asked::Asked;
pub use bounds::Bounds;
pub(crate) use bounds::{Entry, GENUINE, for_each_bound, kind};
pub(crate) use program::Program;
