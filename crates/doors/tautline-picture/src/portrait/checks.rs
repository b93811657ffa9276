//! Refuses data that cannot be drawn.

use tautline_sets::AnySet;

use super::{Corridor, Portrait, PortraitError};

/// Checks lengths and numbers of everything but the Gram matrix.
pub(crate) fn check(portrait: &Portrait<'_>) -> Result<(), PortraitError> {
    let dimension = portrait.dimension;
    if dimension == 0 {
        return Err(PortraitError::NoDimension);
    }
    if let Some([first, second]) = portrait.coordinates
        && dimension > 1
        && (first >= dimension || second >= dimension || first == second)
    {
        return Err(PortraitError::Coordinates { coordinates: [first, second], dimension });
    }
    for (k, point) in portrait.curve.iter().enumerate() {
        vector(point, dimension, || format!("point {k} of the curve"))?;
    }
    for (m, other) in portrait.others.iter().enumerate() {
        for (k, point) in other.iter().enumerate() {
            vector(point, dimension, || format!("point {k} of the other minimum {m}"))?;
        }
    }
    if let Some(found) = &portrait.corridor {
        corridor(found, dimension)?;
    }
    for shape in portrait.pieces().into_iter().flatten() {
        let length = shape.dimension();
        if length != dimension {
            let what = shape.name().to_owned();
            return Err(PortraitError::Length { what, length, dimension });
        }
    }
    Ok(())
}

fn corridor(corridor: &Corridor<'_>, dimension: usize) -> Result<(), PortraitError> {
    for cubes in corridor.levels {
        let what = || "the side of a cube".to_owned();
        finite(cubes.side, what)?;
        require(cubes.side > 0.0, cubes.side, what, "positive")?;
        let length = cubes.places.len() % dimension;
        if length != 0 {
            let what = "the place of the last cube".to_owned();
            return Err(PortraitError::Length { what, length, dimension });
        }
    }
    let [lower, upper] = corridor.bounds;
    finite(upper, || "the upper bound".to_owned())?;
    require(
        0.0 <= lower && lower <= upper,
        lower,
        || "the lower bound".to_owned(),
        "from 0 to the upper one",
    )
}

fn vector(
    values: &[f64],
    dimension: usize,
    what: impl Fn() -> String,
) -> Result<(), PortraitError> {
    if values.len() != dimension {
        return Err(PortraitError::Length { what: what(), length: values.len(), dimension });
    }
    values
        .iter()
        .enumerate()
        .try_for_each(|(k, value)| finite(*value, || format!("coordinate {k} of {}", what())))
}

fn finite(value: f64, what: impl Fn() -> String) -> Result<(), PortraitError> {
    require(value.is_finite(), value, what, "finite")
}

fn require(
    holds: bool,
    value: f64,
    what: impl Fn() -> String,
    want: &'static str,
) -> Result<(), PortraitError> {
    if holds { Ok(()) } else { Err(PortraitError::Number { what: what(), value, want }) }
}
