//! The figures, one a file.

mod asymptotics;
mod certified;
mod convergence;
mod dimension;
mod length_versus_energy;
mod losses;
mod quantities;
mod slack;
mod speeds;
mod tightness;
mod valleys;

use crate::{Failure, data::Data, drawing::Scene, sweep::Sweep};

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
    slack::FIGURE,
    losses::FIGURE,
    dimension::FIGURE,
    valleys::FIGURE,
    length_versus_energy::FIGURE,
    speeds::FIGURE,
    tightness::FIGURE,
    certified::FIGURE,
];
