//! `Artefact`: a figure or a table, from its data to its files.

use std::fmt;

use crate::{
    Failure,
    data::Data,
    drawing::{Scene, pdf, png, svg},
    layout::Layout,
    sweep::Sweep,
};

/// A figure or a table.
#[derive(Clone, Copy, Debug)]
pub struct Artefact {
    /// The name of its files, without the extension.
    pub id: &'static str,
    /// What it shows, in one sentence.
    pub shows: &'static str,
    /// Where its random numbers come from.
    pub seed: Seed,
    /// Whether it contains measured times.
    pub times: Times,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Makes the other files.
    pub form: Form,
    /// Writes pages of Markdown from the data. Each entry is the name of a file in the parent
    /// folder, and its text.
    pub pages: Pages,
}

/// Whether there are measured times, which differ from run to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// There are none.
    None,
    /// Their columns are free, and `--check` compares all others.
    Free,
    /// `--check` leaves the artefact out: there is little else, or it takes too long to compute again.
    Unchecked,
}

/// A function that writes pages.
pub type Pages = fn(&Data) -> Vec<(&'static str, String)>;

/// How the data are shown.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// Drawn as a figure.
    Figure(fn(&Data) -> Result<Scene, Failure>),
    /// Set as a table.
    Table(fn(&Data) -> Result<Layout, Failure>),
}

/// Where the random numbers come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seed {
    /// Nothing is random.
    None,
    /// One seed for all random numbers.
    One(u64),
    /// Each check of the suite has its own seed, which is in its source.
    Suite,
}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Seed::None => f.write_str("none: nothing is random"),
            Seed::One(seed) => write!(f, "{seed}"),
            Seed::Suite => f.write_str("one for each check, in the sources of tautline-checks"),
        }
    }
}

impl Artefact {
    /// Declares a figure.
    pub const fn figure(
        id: &'static str,
        shows: &'static str,
        data: fn(Sweep) -> Result<Data, Failure>,
        draw: fn(&Data) -> Result<Scene, Failure>,
    ) -> Artefact {
        Artefact::new(id, shows, data, Form::Figure(draw))
    }

    /// Declares a table.
    pub const fn table(
        id: &'static str,
        shows: &'static str,
        data: fn(Sweep) -> Result<Data, Failure>,
        layout: fn(&Data) -> Result<Layout, Failure>,
    ) -> Artefact {
        Artefact::new(id, shows, data, Form::Table(layout))
    }

    const fn new(
        id: &'static str,
        shows: &'static str,
        data: fn(Sweep) -> Result<Data, Failure>,
        form: Form,
    ) -> Artefact {
        let pages: Pages = |_| Vec::new();
        Artefact { id, shows, seed: Seed::None, times: Times::None, data, form, pages }
    }

    /// Returns the same artefact with random numbers.
    #[must_use]
    pub const fn seeded(self, seed: Seed) -> Artefact {
        Artefact { seed, ..self }
    }

    /// Returns the same artefact with measured times.
    #[must_use]
    pub const fn timed(self, times: Times) -> Artefact {
        Artefact { times, ..self }
    }

    /// Returns the same table with pages.
    #[must_use]
    pub const fn with_pages(self, pages: Pages) -> Artefact {
        Artefact { pages, ..self }
    }

    /// Returns the name of the data file, relative to the package.
    #[must_use]
    pub fn data_file(&self) -> String {
        match self.form {
            Form::Figure(_) => format!("data/{}.csv", self.id),
            Form::Table(_) => format!("tables/{}.csv", self.id),
        }
    }

    /// Returns the comment above the data, which says what they are and how to reproduce them.
    #[must_use]
    pub fn comment(&self) -> String {
        let Artefact { id, shows, seed, .. } = self;
        let command = match self.form {
            Form::Figure(_) => "figures",
            Form::Table(_) => "tables",
        };
        let version = env!("CARGO_PKG_VERSION");
        format!(
            "{id}\n{shows}\ncommand: cargo xtask {command} {id}\nversion: {version}\nseed: {seed}"
        )
    }

    /// Returns the other files, made from the data as they are printed.
    ///
    /// # Errors
    ///
    /// If the data cannot be drawn or set.
    pub fn files(&self, data: &Data) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let figure = |ending: &str| format!("figures/{}.{ending}", self.id);
        let table = |ending: &str| format!("tables/{}.{ending}", self.id);
        let mut files = match self.form {
            Form::Figure(draw) => {
                let scene = draw(data)?;
                let pictures = [("svg", svg(&scene)), ("png", png(&scene)?), ("pdf", pdf(&scene))];
                Vec::from(pictures.map(|(ending, bytes)| (figure(ending), bytes)))
            }
            Form::Table(layout) => {
                let layout = layout(data)?;
                let texts = [("md", layout.markdown()), ("tex", layout.latex())];
                Vec::from(texts.map(|(ending, text)| (table(ending), text.into_bytes())))
            }
        };
        let pages = (self.pages)(data).into_iter();
        files.extend(pages.map(|(name, text)| (name.to_owned(), text.into_bytes())));
        Ok(files)
    }
}
