//! Mutants: deliberately wrong variants of the library, to which the suite is put.

mod enclosures;
mod formula;
mod mistakes;
mod mutant;
mod mutations;
mod sharper;
mod solver;
mod theorems;

pub use mutant::Mutant;
