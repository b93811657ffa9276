//! Mutants: deliberately wrong variants of the library, to which the suite is put.

mod mistakes;
mod mutant;
mod mutations;
mod sharper;

pub use mutant::Mutant;
