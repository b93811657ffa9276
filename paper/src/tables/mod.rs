//! The tables, one a file.

mod constants;
mod convergence;
mod counterexample;
mod layout;
mod tightness;

pub use layout::Layout;

use crate::{Failure, data::Data, sweep::Sweep};

/// A table: its data and how it is set.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// The name of its files.
    pub id: &'static str,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// The seed of its random numbers, if there are any.
    pub seed: Option<u64>,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Chooses columns and writes their heads.
    pub layout: fn(&Data) -> Result<Layout, Failure>,
}

/// All tables.
pub const TABLES: [Table; 4] =
    [constants::TABLE, convergence::TABLE, counterexample::TABLE, tightness::TABLE];
