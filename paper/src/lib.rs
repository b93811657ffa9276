//! The figures and tables of the paper, computed, checked and drawn.
//!
//! `cargo xtask figures` and `cargo xtask tables` run [`command::run`]. A [`figures::Figure`]
//! is two functions, from a sweep over `N` to [`data::Data`] and from the data to a scene; a table
//! likewise, if the feature `tables` is on, as it is by default. The data carry the tolerance of each column,
//! so that `--check` compares what was recomputed with what is committed.

pub mod artefact;
pub mod asymptotics;
pub mod case;
pub mod certified;
pub mod command;
pub mod convergence;
#[cfg(feature = "tables")]
pub mod corpus;
pub mod data;
pub mod failure;
pub mod figures;
pub mod grid;
pub mod observation;
pub mod output;
pub mod parallel;
pub mod section_5;
pub mod sweep;
#[cfg(feature = "tables")]
pub mod tables;

pub use failure::Failure;
pub use tautline_drawing as drawing;
