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
    /// The name of its files.
    pub id: &'static str,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// Where its random numbers come from.
    pub seed: Seed,
    /// Whether it contains measured times, which differ from run to run.
    pub timed: bool,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Makes the other files.
    pub form: Form,
    /// Writes pages of Markdown from the data: their names in the folder above, and their texts.
    pub pages: Pages,
}

/// Writes pages.
pub type Pages = fn(&Data) -> Vec<(&'static str, String)>;

/// How data are shown.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// Drawn.
    Figure(fn(&Data) -> Result<Scene, Failure>),
    /// Set as a table.
    Table(fn(&Data) -> Result<Layout, Failure>),
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

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Seed::None => f.write_str("none: nothing is random"),
            Seed::One(seed) => write!(f, "{seed}"),
            Seed::Suite => f.write_str("one for each check, in the sources of tautline-suite"),
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
        Artefact { id, shows, seed: Seed::None, timed: false, data, form, pages }
    }

    /// The same with random numbers.
    #[must_use]
    pub const fn seeded(self, seed: Seed) -> Artefact {
        Artefact { seed, ..self }
    }

    /// The same table with measured times.
    #[must_use]
    pub const fn timed(self) -> Artefact {
        Artefact { timed: true, ..self }
    }

    /// The same table with pages.
    #[must_use]
    pub const fn with_pages(self, pages: Pages) -> Artefact {
        Artefact { pages, ..self }
    }

    /// Returns the data file, relative to the package.
    #[must_use]
    pub fn data_file(&self) -> String {
        match self.form {
            Form::Figure(_) => format!("data/{}.csv", self.id),
            Form::Table(_) => format!("tables/{}.csv", self.id),
        }
    }

    /// Returns the comment above the data: what they are, and how to make them.
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
    /// Data that cannot be drawn or set.
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
