//! Refuses data that cannot be drawn.

use super::{Corridor, Portrait, PortraitError, Shape};

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
    portrait.ends.iter().flat_map(|end| end.iter()).try_for_each(|shape| set(shape, dimension))
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

fn set(shape: &Shape, dimension: usize) -> Result<(), PortraitError> {
    let vector = |values: &[f64], what: &str| vector(values, dimension, || what.to_owned());
    match shape {
        Shape::Point(point) => vector(point, "a point"),
        Shape::Points(points) => points.iter().try_for_each(|p| vector(p, "a point of a set")),
        Shape::Ball { centre, radius } | Shape::Sphere { centre, radius } => {
            vector(centre, &format!("the centre of {}", shape.name()))?;
            let what = || format!("the radius of {}", shape.name());
            finite(*radius, what)?;
            require(*radius >= 0.0, *radius, what, "at least 0")
        }
        Shape::AxisBox { low, high } => {
            length(low, dimension, || "the lower corner of a box".to_owned())?;
            length(high, dimension, || "the upper corner of a box".to_owned())?;
            for (low, high) in low.iter().zip(high) {
                let what = || "the lower end of the side of a box".to_owned();
                require(*low < f64::INFINITY, *low, what, "a number below ∞")?;
                let what = || format!("the upper end of the side of a box from {low}");
                require(*high > f64::NEG_INFINITY, *high, what, "a number above −∞")?;
                require(low <= high, *high, what, "at least its lower end")?;
            }
            Ok(())
        }
        Shape::HalfSpace { normal, offset } => {
            vector(normal, "the normal of a half-space")?;
            let longest = normal.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
            require(longest > 0.0, longest, || "the normal of a half-space".into(), "nonzero")?;
            finite(*offset, || "the offset of a half-space".to_owned())
        }
        Shape::Segment { from, to } => {
            vector(from, "the end of a segment")?;
            vector(to, "the end of a segment")
        }
        Shape::AffineSubspace { point, directions } => {
            vector(point, "the point of an affine subspace")?;
            directions.iter().try_for_each(|d| vector(d, "the direction of an affine subspace"))
        }
    }
}

fn vector(
    values: &[f64],
    dimension: usize,
    what: impl Fn() -> String,
) -> Result<(), PortraitError> {
    length(values, dimension, &what)?;
    values
        .iter()
        .enumerate()
        .try_for_each(|(k, value)| finite(*value, || format!("coordinate {k} of {}", what())))
}

fn length(
    values: &[f64],
    dimension: usize,
    what: impl Fn() -> String,
) -> Result<(), PortraitError> {
    if values.len() == dimension {
        Ok(())
    } else {
        Err(PortraitError::Length { what: what(), length: values.len(), dimension })
    }
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
