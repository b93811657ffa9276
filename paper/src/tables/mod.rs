//! The tables, one a file.

mod asymptotics;
mod certified_constants;
mod certified_curves;
mod certified_times;
mod constants;
mod convergence;
mod corpus;
mod counterexample;
mod errata;
pub mod layout;
mod mutants;
mod rates;
mod statements;
mod tightness;

pub use layout::Layout;

use crate::{Failure, artefact::Artefact, data::Data, sweep::Sweep};

/// A table: its data and how it is set.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// The name of its files.
    pub id: &'static str,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// The seed of its random numbers, or where it stands.
    pub seed: Seed,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Chooses columns and writes their heads.
    pub layout: fn(&Data) -> Result<Layout, Failure>,
    /// Whether it can be computed again: not so for times.
    pub repeatable: bool,
    /// Pages of Markdown that are written from the data too: their names, beside the folder of
    /// the tables, and their texts.
    pub pages: fn(&Data) -> Vec<(&'static str, String)>,
}

/// Where random numbers come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seed {
    /// Nothing is random.
    None,
    /// One seed for all.
    One(u64),
    /// Each check of the suite has its own, in its source.
    Suite,
}

impl std::fmt::Display for Seed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Seed::None => f.write_str("none: nothing is random"),
            Seed::One(seed) => write!(f, "{seed}"),
            Seed::Suite => f.write_str("one for each check, in the sources of tautline-suite"),
        }
    }
}

/// No pages.
fn no_pages(_: &Data) -> Vec<(&'static str, String)> {
    Vec::new()
}

/// All tables.
pub const TABLES: [Table; 13] = [
    asymptotics::TABLE,
    certified_constants::TABLE,
    certified_curves::TABLE,
    certified_times::TABLE,
    constants::TABLE,
    convergence::TABLE,
    corpus::TABLE,
    counterexample::TABLE,
    errata::TABLE,
    mutants::TABLE,
    rates::TABLE,
    statements::TABLE,
    tightness::TABLE,
];

impl Artefact for Table {
    fn id(&self) -> &'static str {
        self.id
    }

    fn shows(&self) -> &'static str {
        self.shows
    }

    fn data_file(&self) -> (String, &'static str) {
        (format!("tables/{}.csv", self.id), "tables")
    }

    fn repeatable(&self) -> bool {
        self.repeatable
    }

    fn seed(&self) -> String {
        self.seed.to_string()
    }

    fn compute(&self, sweep: Sweep) -> Result<Data, Failure> {
        (self.data)(sweep)
    }

    fn files(&self, data: &Data) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let layout = (self.layout)(data)?;
        let file = |ending: &str| format!("tables/{}.{ending}", self.id);
        let mut files = vec![
            (file("md"), layout.markdown().into_bytes()),
            (file("tex"), layout.latex().into_bytes()),
        ];
        let pages = (self.pages)(data).into_iter();
        files.extend(pages.map(|(name, text)| (name.to_owned(), text.into_bytes())));
        Ok(files)
    }
}
