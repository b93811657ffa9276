//! Metrics with obstacles.

use tautline::{
    ANY, Formula,
    formula::{Part, Written, WrittenError},
};

use super::{GivenError, Shape, given::check_coordinates};
use crate::reading::obstacles::{distance, factor};

/// A region that no curve enters.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// A ball of positive radius, or a half-space.
    Set(Shape),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(String),
}

/// Returns the metric `(1 + Σₖ (m/δₖ)²) H` with the distances `δₖ` from regions, which is undefined in them.
pub(super) fn avoiding(
    formula: &Formula<ANY>,
    regions: &[Region],
    margin: f64,
) -> Result<Formula<ANY>, GivenError> {
    if !(margin > 0.0 && margin.is_finite()) {
        return Err(GivenError::Margin { margin });
    }
    let mut distances = Vec::new();
    for region in regions {
        let text = match region {
            Region::Negative(text) => text.clone(),
            Region::Set(shape) => {
                check_coordinates(shape, formula.dimension())?;
                distance(shape).ok_or(GivenError::NoInside { set: shape.name() })?
            }
        };
        distances.push(text);
    }
    let factor = factor(distances.len(), margin);
    fn part(text: &str) -> Part<'_> {
        Part { text, id: 0 }
    }
    let distances = distances.iter().map(|text| part(text)).collect();
    let metric = Box::new(Written::Recorded(formula.clone()));
    let metric = Written::Weighted(distances, part(&factor), metric);
    let formula = Formula::compose_in(formula.dimension(), &[], &[], &[], &metric);
    formula.map_err(|WrittenError { error, .. }| GivenError::Text(error))
}
