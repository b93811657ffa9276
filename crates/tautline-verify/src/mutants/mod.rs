//! Mutants: deliberately wrong variants of the library, to which the suite is put.

mod mistakes;
mod mutant;
mod mutations;

pub use mutant::Mutant;
