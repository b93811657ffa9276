//! The closed sets that shapes stand for, in any dimension.

use std::{ops::Range, sync::Arc};

use tautline::{
    ANY, AffineSubspace, AnySet, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, SVector,
    Segment, SetError, Shape as Set, Sphere, Union,
};
use tautline_picture::portrait::Shape;

use crate::Diagnostic;

/// A shape of an end, and where it stands in the file.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) shape: Shape,
    /// The bytes of each number or vector that an error may blame: those of the shape's fields in
    /// their order, or of the single points or directions of the last field.
    pub(crate) places: Vec<Range<usize>>,
}

impl Piece {
    /// Returns the bytes that this error blames.
    fn place(&self, error: &SetError) -> Range<usize> {
        let last = self.places.len().saturating_sub(1);
        let place = match (*error, &self.shape) {
            // The directions come after the point.
            (SetError::DependentDirection { index, .. }, _) => index + 1,
            (SetError::CrossedCorners { .. }, _) | (SetError::NegativeRadius { .. }, _) => 1,
            _ => 0,
        };
        self.places.get(place.min(last)).cloned().unwrap_or_default()
    }

    pub(crate) fn set<const D: usize>(&self) -> Result<Arc<dyn ClosedSet<D>>, Diagnostic> {
        set_of(&self.shape).map_err(|error| Diagnostic::new(error.to_string(), self.place(&error)))
    }
}

/// Returns the set, whose vectors must have `D` coordinates.
pub(crate) fn set_of<const D: usize>(shape: &Shape) -> Result<Arc<dyn ClosedSet<D>>, SetError> {
    let set = in_any(shape)?;
    let found = set.dimension();
    let set: Option<Set<D>> = set.into_dimension();
    let other = SetError::Coordinates { what: shape.name(), found, dimension: D };
    set.map(|set| Arc::new(set) as _).ok_or(other)
}

/// Returns the set in a dimension that is a value.
fn in_any(shape: &Shape) -> Result<Set<ANY>, SetError> {
    match shape {
        Shape::Point(x) => Point::from_slice(x).map(Set::Point),
        Shape::Points(points) => FiniteSet::from_slices(points).map(Set::FiniteSet),
        Shape::Ball { centre, radius } => Ball::from_slice(centre, *radius).map(Set::Ball),
        Shape::Sphere { centre, radius } => Sphere::from_slice(centre, *radius).map(Set::Sphere),
        Shape::AxisBox { low, high } => AxisBox::from_slices(low, high).map(Set::AxisBox),
        Shape::HalfSpace { normal, offset } => {
            HalfSpace::from_slice(normal, *offset).map(Set::HalfSpace)
        }
        Shape::Segment { from, to } => Segment::from_slices(from, to).map(Set::Segment),
        Shape::AffineSubspace { point, directions } => {
            AffineSubspace::from_slices(point, directions).map(Set::AffineSubspace)
        }
    }
}

/// Returns the first `D` coordinates.
pub(crate) fn vector<const D: usize>(x: &[f64]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or(0.0))
}

/// Returns the union of the pieces, or the only one.
pub(crate) fn union<const D: usize>(pieces: &[Piece]) -> Result<Arc<dyn ClosedSet<D>>, Diagnostic> {
    let mut sets = pieces.iter().map(Piece::set).collect::<Result<Vec<_>, _>>()?;
    if sets.len() == 1 {
        return Ok(sets.remove(0));
    }
    let at = pieces.first().and_then(|piece| piece.places.first()).cloned().unwrap_or_default();
    let union = Union::new(sets).map_err(|error| Diagnostic::new(error.to_string(), at))?;
    Ok(Arc::new(union))
}
