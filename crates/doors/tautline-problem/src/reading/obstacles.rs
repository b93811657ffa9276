//! The obstacles of a file, as a factor of the metric.

use std::ops::Range;

use tautline_any::{distance, factor};

use crate::{
    Diagnostic,
    file::{
        ProblemFile,
        expression::Text,
        obstacles::{ObstaclesFile, RegionFile},
    },
    reading::{
        numbers::Numbers,
        pieces::{Draft, draft},
    },
};

/// The distance from a region.
pub(crate) enum Distance<'f> {
    /// The text of an expression.
    Own(String),
    /// An expression of the file.
    Given(&'f Text),
}

/// The obstacles of a file.
pub(crate) struct Obstacles<'f> {
    pub(crate) distances: Vec<Distance<'f>>,
    /// The factor of the metric, an expression of the distances, as [`factor`] writes it.
    pub(crate) factor: String,
    /// The place of the regions.
    pub(crate) place: Range<usize>,
}

/// Reads the section `[obstacles]`.
pub(crate) fn obstacles<'f>(
    problem: &'f ProblemFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Option<Obstacles<'f>>, Diagnostic> {
    let Some(section) = &problem.obstacles else { return Ok(None) };
    let ObstaclesFile { regions, margin } = section.get_ref();
    let margin = numbers.between(margin, 0.0, f64::INFINITY)?;
    let mut distances = Vec::new();
    for region in regions.get_ref() {
        let solid = match region {
            RegionFile::Ball(solid) | RegionFile::HalfSpace(solid) | RegionFile::Box(solid) => {
                solid
            }
            RegionFile::Negative(text) => {
                distances.push(Distance::Given(text));
                continue;
            }
        };
        let Draft { shape, places } = draft(solid, numbers, dimension)?;
        let text = shape.ok().and_then(|shape| distance(&shape, margin)).ok_or_else(|| {
            let place = places.last().cloned().unwrap_or(regions.span());
            Diagnostic::new("an obstacle without inside", place)
                .label("expected a positive radius, or a normal that is not 0")
        })?;
        distances.push(Distance::Own(text));
    }
    let factor = factor(distances.len(), margin);
    Ok(Some(Obstacles { distances, factor, place: regions.span() }))
}
