//! The figures and tables of the paper, computed, checked and drawn.
//!
//! `cargo xtask figures` and `cargo xtask tables` run [`command::run`]. An [`artefact::Artefact`]
//! consists of two functions: one from a sweep over `N` to [`data::Data`], and one from the data to
//! a scene or a table. The data have a tolerance for each column, with which `--check` compares
//! recomputed and committed numbers. The tables need the feature `tables`, which is on by default.

pub mod artefact;
pub mod asymptotics;
pub mod case;
mod cases;
#[cfg(feature = "tables")]
mod certificates;
#[cfg(feature = "tables")]
mod certified;
pub mod command;
mod convergence;
#[cfg(feature = "tables")]
pub mod corpus;
pub mod data;
mod decoder;
pub mod failure;
pub mod figures;
pub mod grid;
pub mod layout;
mod methods;
mod observation;
pub mod output;
pub mod parallel;
pub mod said;
pub mod section_5;
pub mod sweep;
#[cfg(feature = "tables")]
pub mod tables;

pub use failure::Failure;
pub use tautline_picture as drawing;
