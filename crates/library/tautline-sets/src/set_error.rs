//! `SetError`: why a closed set, or a pair of them, is refused.

use tautline_scalar::ANY;

/// A condition that the data of a set, or of a pair of sets, violate.
///
/// Each variant carries the offending numbers, so that the message shows what to change.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SetError {
    /// A point or a vector of `R^D` must have finite coordinates.
    #[error("{what} has the non-finite coordinate {value} at index {index}")]
    NonFiniteCoordinate {
        /// The point or vector, in words.
        what: &'static str,
        /// The index of the first coordinate that is not finite, counted from 0.
        index: usize,
        /// The coordinate.
        value: f64,
    },
    /// A point or a vector must have as many coordinates as the space.
    #[error("{what} has {found} coordinates in dimension {dimension}")]
    Coordinates {
        /// The point, the vector or the set, in words.
        what: &'static str,
        /// The number of its coordinates.
        found: usize,
        /// The dimension of the space.
        dimension: usize,
    },
    /// A point or a vector must have coordinates.
    #[error("{what} has no coordinates")]
    NoCoordinates {
        /// The point or vector, in words.
        what: &'static str,
    },
    /// A length or an offset must be finite.
    #[error("{what} {value} must be finite")]
    NonFinite {
        /// The number, in words.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// A radius must be at least zero. Zero is allowed, since a point is closed.
    #[error("radius {radius} must be ≥ 0")]
    NegativeRadius {
        /// The radius that was given.
        radius: f64,
    },
    /// A half-width must be at least zero. Zero is allowed, since a flat box is closed.
    #[error("half-width {half_width} at index {index} must be ≥ 0")]
    NegativeHalfWidth {
        /// The index of the first negative half-width, counted from 0.
        index: usize,
        /// The half-width that was given.
        half_width: f64,
    },
    /// The lower corner of a box must not exceed the upper one, or else the box is empty.
    #[error("lower corner {lower} must be ≤ upper corner {upper} at index {index}")]
    CrossedCorners {
        /// The index of the first coordinate at which the corners are crossed, counted from 0.
        index: usize,
        /// The coordinate of the lower corner.
        lower: f64,
        /// The coordinate of the upper corner.
        upper: f64,
    },
    /// A period must be finite and at least 0, which says that a coordinate is not periodic.
    #[error("the period {value} of coordinate {} must be finite and ≥ 0", index + 1)]
    Period {
        /// The index of the coordinate, counted from 0.
        index: usize,
        /// The period that was given.
        value: f64,
    },
    /// Along a coordinate with a period two sets may together extend over half of the period, so that one
    /// translate is the nearest; a set without end must be its own translate.
    #[error(
        "along coordinate {} the sets extend over {extent}, more than half of the period {period}", index + 1
    )]
    Extent {
        /// The index of the coordinate, counted from 0.
        index: usize,
        /// The sum of the extents of a piece of each set, in `ℓ`.
        extent: f64,
        /// The period.
        period: f64,
    },
    /// The normal of a half-space must not be zero, or else the half-space is everything or
    /// nothing.
    #[error("the normal of a half-space must not be 0")]
    ZeroNormal,
    /// The directions of an affine subspace must be linearly independent.
    #[error(
        "direction {index} depends on those before it: the part orthogonal to them is {remainder:e} of its length"
    )]
    DependentDirection {
        /// The index of the first dependent direction, counted from 0.
        index: usize,
        /// The length of the part that is orthogonal to the earlier directions, relative to the
        /// length of the direction.
        remainder: f64,
    },
    /// A set is made of the parts of its [`Kind`](crate::kind::Kind).
    #[error("these are not the parts that describe {what}")]
    Parts {
        /// The kind of set, in words.
        what: &'static str,
    },
    /// A union or a finite set must have members: a curve has to end somewhere (Proposition 7.1).
    #[error("the set is empty: it has no members (Proposition 7.1 needs non-empty sets)")]
    Empty,
    /// A non-empty closed set has a nearest point to each point (Proposition 7.1).
    #[error(
        "the {end} end set has no nearest point (coordinate {index} is {value}): is it empty? (Proposition 7.1 needs non-empty sets)"
    )]
    NoNearestPoint {
        /// The end in question: `first` or `second`.
        end: &'static str,
        /// The index of the first coordinate that is not finite, counted from 0.
        index: usize,
        /// The coordinate.
        value: f64,
    },
    /// One of the end sets must be bounded, or else the infimum may lie at infinity.
    #[error("both end sets are unbounded (Proposition 7.1 needs a bounded one)")]
    BothUnbounded,
}

/// Returns the dimension that the compiler knows, if it knows one.
pub(crate) fn known(dimension: usize) -> Option<usize> {
    (dimension != ANY).then_some(dimension)
}

/// Returns the first coordinate that is NaN or infinite, with its index.
pub(crate) fn non_finite(x: &[f64]) -> Option<(usize, f64)> {
    x.iter().copied().enumerate().find(|(_, value)| !value.is_finite())
}

/// Returns `x` if all its coordinates are finite, and as many as the dimension, if that is known.
pub(crate) fn finite_vector(
    what: &'static str,
    x: &[f64],
    dimension: Option<usize>,
) -> Result<Box<[f64]>, SetError> {
    match (dimension, non_finite(x)) {
        (None, _) if x.is_empty() => Err(SetError::NoCoordinates { what }),
        (Some(dimension), _) if x.len() != dimension => {
            Err(SetError::Coordinates { what, found: x.len(), dimension })
        }
        (_, Some((index, value))) => Err(SetError::NonFiniteCoordinate { what, index, value }),
        _ => Ok(x.into()),
    }
}

/// Returns `value` if it is finite.
pub(crate) fn finite(what: &'static str, value: f64) -> Result<f64, SetError> {
    if value.is_finite() { Ok(value) } else { Err(SetError::NonFinite { what, value }) }
}

/// Returns the radius if it lies in `[0, ∞)`.
pub(crate) fn valid_radius(radius: f64) -> Result<f64, SetError> {
    let radius = finite("radius", radius)?;
    if radius >= 0.0 { Ok(radius) } else { Err(SetError::NegativeRadius { radius }) }
}

#[cfg(test)]
mod tests {
    use super::SetError;

    #[test]
    fn the_message_names_the_clause_and_the_number() {
        let table = [
            (
                SetError::NonFiniteCoordinate { what: "the centre", index: 1, value: f64::NAN },
                "the centre has the non-finite coordinate NaN at index 1",
            ),
            (SetError::NegativeRadius { radius: -1.0 }, "radius -1 must be ≥ 0"),
            (
                SetError::CrossedCorners { index: 2, lower: 3.0, upper: 1.5 },
                "lower corner 3 must be ≤ upper corner 1.5 at index 2",
            ),
            (
                SetError::DependentDirection { index: 1, remainder: 0.0 },
                "direction 1 depends on those before it: the part orthogonal to them is 0e0 of its length",
            ),
            (
                SetError::BothUnbounded,
                "both end sets are unbounded (Proposition 7.1 needs a bounded one)",
            ),
        ];
        for (error, message) in table {
            assert_eq!(error.to_string(), message);
        }
    }
}
