//! The figures, one in each file.

mod asymptotics;
mod certified;
mod convergence;
mod dimension;
mod excess_bounds;
mod length_versus_energy;
mod losses;
mod methods;
mod overestimation;
mod quantities;
mod sandwich;
mod speeds;
mod tightness;
mod valleys;

use crate::{Failure, artefact::Artefact, drawing::SlopeTriangle};

/// All figures.
pub const FIGURES: &[Artefact] = &[
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
    sandwich::FIGURE,
    methods::FIGURE,
];

/// Returns a triangle half a decade below the last third of a decreasing series.
fn triangle_below(points: &[(f64, f64)], slope: f64) -> Result<SlopeTriangle, Failure> {
    let at = points
        .get(points.len() * 2 / 3)
        .ok_or_else(|| Failure::Data("a series without points".to_owned()))?;
    let (start, end) = (at.0 / 4.0, at.0);
    Ok(SlopeTriangle::below(slope, start, end, 0.3 * at.1 * (start / end).powf(slope)))
}
