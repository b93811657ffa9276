//! The project's own suite: checks that run against the library or against a mutant.
//!
//! [`battery`] has the checks; [`strategies`] and [`arbitrary`] draw their cases. [`GridLine`]
//! finds global minima on a grid, with which the minima of the solver are compared. The [`adversary`]
//! searches for the case in which a statement is tightest.

pub mod adversary;
pub mod arbitrary;
pub mod battery;
mod dynamic_programming;
pub mod strategies;

pub use dynamic_programming::{GridLine, GridMinimum};
