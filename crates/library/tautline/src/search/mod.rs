//! Searches beyond the one from given starts on one grid.

mod elsewhere;
mod lattice;
mod resolution;
pub(crate) mod tolerance;
