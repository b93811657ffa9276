//! Metrics with obstacles.

use tautline::{
    Formula,
    formula::{Part, Written, WrittenError},
};

use super::{Given, GivenError, Shape, sets::check_coordinates};
use crate::{
    known::Known,
    reading::obstacles::{distance, factor},
};

/// A region that no curve enters.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// A ball of positive radius, or a half-space.
    Set(Shape),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(String),
}

/// Returns the metric `(1 + Σₖ (m/δₖ)²) H` with the distances `δₖ` from regions, which is undefined in them.
pub(super) fn avoiding<const D: usize>(
    formula: &Formula<D>,
    regions: &[Region],
    margin: f64,
) -> Result<Given, GivenError> {
    if !(margin > 0.0 && margin.is_finite()) {
        return Err(GivenError::Margin { margin });
    }
    let mut distances = Vec::new();
    for region in regions {
        let text = match region {
            Region::Negative(text) => text.clone(),
            Region::Set(shape) => {
                check_coordinates::<D>(shape)?;
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
    let metric = Box::new(Written::Recorded(formula.clone().into_any()));
    let metric = Written::Weighted(distances, part(&factor), metric);
    let formula = Formula::<D>::compose(&[], &[], &[], &metric);
    let formula = formula.map_err(|WrittenError { error, .. }| GivenError::Text(error))?;
    Ok(Given::held(Known::Formula(formula)))
}
