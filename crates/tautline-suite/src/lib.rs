//! The project's own suite: checks that run against the library, or against a deliberately wrong variant of it.
//!
//! [`battery`] has the checks, [`strategies`] and [`arbitrary`] draw their cases; [`GridLine`] finds minima on a
//! grid, by which those of the solver are judged.

pub mod arbitrary;
pub mod battery;
mod dynamic_programming;
pub mod strategies;

pub use dynamic_programming::{GridLine, GridMinimum};
