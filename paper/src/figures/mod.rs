//! The figures, one a file.

mod asymptotics;
mod certified;
mod convergence;
mod dimension;
mod length_versus_energy;
mod losses;
mod overestimation;
mod quantities;
mod speeds;
mod tightness;
mod valleys;

use crate::{
    Failure,
    artefact::Artefact,
    data::Data,
    drawing::{Scene, pdf, png, svg},
    sweep::Sweep,
};

/// A figure: its data and its drawing.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// The name of its files.
    pub id: &'static str,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// Computes and checks the data.
    pub data: fn(Sweep) -> Result<Data, Failure>,
    /// Draws the data, and nothing else.
    pub draw: fn(&Data) -> Result<Scene, Failure>,
}

/// All figures.
pub const FIGURES: [Figure; 11] = [
    convergence::FIGURE,
    quantities::FIGURE,
    asymptotics::FIGURE,
    overestimation::FIGURE,
    losses::FIGURE,
    dimension::FIGURE,
    valleys::FIGURE,
    length_versus_energy::FIGURE,
    speeds::FIGURE,
    tightness::FIGURE,
    certified::FIGURE,
];

impl Artefact for Figure {
    fn id(&self) -> &'static str {
        self.id
    }

    fn shows(&self) -> &'static str {
        self.shows
    }

    fn data_file(&self) -> (String, &'static str) {
        (format!("data/{}.csv", self.id), "figures")
    }

    fn compute(&self, sweep: Sweep) -> Result<Data, Failure> {
        (self.data)(sweep)
    }

    fn files(&self, data: &Data) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let scene = (self.draw)(data)?;
        let file = |ending: &str| format!("figures/{}.{ending}", self.id);
        Ok(vec![
            (file("svg"), svg(&scene)),
            (file("png"), png(&scene)?),
            (file("pdf"), pdf(&scene)),
        ])
    }
}
