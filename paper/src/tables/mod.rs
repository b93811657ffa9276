//! The tables, one a file.

mod constants;
mod convergence;
mod counterexample;
mod errata;
mod layout;
mod mutants;
mod statements;

pub use layout::Layout;

use crate::{Failure, data::Data, sweep::Sweep};

/// A table: its data and how it is set.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// The name of its files.
    pub id: &'static str,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Chooses columns and writes their heads.
    pub layout: fn(&Data) -> Result<Layout, Failure>,
    /// Pages of Markdown that are written from the data too: their names, beside the folder of
    /// the tables, and their texts.
    pub pages: fn(&Data) -> Vec<(&'static str, String)>,
}

/// No pages.
fn no_pages(_: &Data) -> Vec<(&'static str, String)> {
    Vec::new()
}

/// All tables.
pub const TABLES: [Table; 6] = [
    constants::TABLE,
    convergence::TABLE,
    counterexample::TABLE,
    errata::TABLE,
    mutants::TABLE,
    statements::TABLE,
];
