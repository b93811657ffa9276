//! The sets of a problem: shapes in a dimension that is a value.

use std::ops::Range;

use tautline::{ANY, SetError, Shape};

use crate::Diagnostic;

/// A shape of an end, and where it stands in the file.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) shape: Shape<ANY>,
    /// The bytes of each number or vector that an error may blame: those of the shape's fields in
    /// their order, or of the single points or directions of the last field.
    pub(crate) places: Vec<Range<usize>>,
}

/// Says why numbers at these places are not those of a set.
pub(crate) fn refused(error: &SetError, places: &[Range<usize>]) -> Diagnostic {
    let place = match *error {
        // The directions come after the point.
        SetError::DependentDirection { index, .. } => index + 1,
        SetError::CrossedCorners { .. } | SetError::NegativeRadius { .. } => 1,
        _ => 0,
    };
    let place = places.get(place).or(places.last()).cloned().unwrap_or_default();
    Diagnostic::new(error.to_string(), place)
}
