//! The sets of a problem: shapes in a dimension that is a value.

use std::{ops::Range, sync::Arc};

use tautline::{ANY, ClosedSet, SVector, SetError, Shape, Union};

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

/// Returns the first `D` coordinates.
pub(crate) fn vector<const D: usize>(x: &[f64]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or(0.0))
}

/// Returns the union of shapes in `D` dimensions, or the only one.
pub(crate) fn union<'s, const D: usize>(
    shapes: impl Iterator<Item = &'s Shape<ANY>>,
) -> Result<Arc<dyn ClosedSet<D>>, SetError> {
    let set = |shape: &Shape<ANY>| -> Result<Arc<dyn ClosedSet<D>>, SetError> {
        Ok(Arc::new(shape.clone().into_dimension()?))
    };
    let mut sets = shapes.map(set).collect::<Result<Vec<_>, _>>()?;
    if sets.len() == 1 { Ok(sets.remove(0)) } else { Ok(Arc::new(Union::new(sets)?)) }
}
