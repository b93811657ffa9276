//! The figures and tables of the paper, computed, checked and drawn.
//!
//! `cargo xtask figures` and `cargo xtask tables` run [`command::run`]. An [`artefact::Artefact`]
//! is two functions: from a sweep over `N` to [`data::Data`], and from the data to a scene or a
//! table. The data carry a tolerance for each column, by which `--check` compares recomputed with
//! committed numbers. The tables need the feature `tables`, which is on by default.

pub mod artefact;
pub mod asymptotics;
pub mod case;
mod cases;
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
mod observation;
pub mod output;
pub mod parallel;
pub mod section_5;
pub mod sweep;
#[cfg(feature = "tables")]
pub mod tables;

pub use failure::Failure;
pub use tautline_drawing as drawing;
