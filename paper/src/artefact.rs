//! `Artefact`: what the commands have in common to make, a figure or a table.

use crate::{Failure, data::Data, sweep::Sweep};

/// A figure or a table.
pub trait Artefact: Sync {
    /// The name of its files.
    fn id(&self) -> &'static str;

    /// What it shows, in a sentence.
    fn shows(&self) -> &'static str;

    /// The data file, and the command that makes it.
    fn data_file(&self) -> (String, &'static str);

    /// Whether it comes out the same a second time.
    fn repeatable(&self) -> bool {
        true
    }

    /// Where its random numbers come from.
    fn seed(&self) -> String {
        "none: nothing is random".to_owned()
    }

    /// Computes and checks the data.
    ///
    /// # Errors
    ///
    /// A failed computation or a violated inequality.
    fn compute(&self, sweep: Sweep) -> Result<Data, Failure>;

    /// The other files, made from the data as they are printed.
    ///
    /// # Errors
    ///
    /// Data that cannot be drawn or set.
    fn files(&self, data: &Data) -> Result<Vec<(String, Vec<u8>)>, Failure>;
}
