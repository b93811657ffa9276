//! Searches beyond the one from given starts on one grid.

mod elsewhere;
mod lattice;
mod resolution;
mod round;
pub(crate) mod tolerance;
