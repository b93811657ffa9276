//! The closed sets that shapes stand for, in any dimension.

use std::{ops::Range, sync::Arc};

use tautline::{
    AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, SVector, Segment,
    SetError, Sphere, Union,
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

/// Returns the set. The vectors must have `D` coordinates; missing ones count as 0.
pub(crate) fn set_of<const D: usize>(shape: &Shape) -> Result<Arc<dyn ClosedSet<D>>, SetError> {
    let at = vector::<D>;
    Ok(match shape {
        Shape::Point(x) => Arc::new(Point::new(at(x))?),
        Shape::Points(points) => Arc::new(FiniteSet::new(points.iter().map(|x| at(x)))?),
        Shape::Ball { centre, radius } => Arc::new(Ball::new(at(centre), *radius)?),
        Shape::Sphere { centre, radius } => Arc::new(Sphere::new(at(centre), *radius)?),
        Shape::AxisBox { low, high } => Arc::new(AxisBox::from_corners(at(low), at(high))?),
        Shape::HalfSpace { normal, offset } => Arc::new(HalfSpace::new(at(normal), *offset)?),
        Shape::Segment { from, to } => Arc::new(Segment::new(at(from), at(to))?),
        Shape::AffineSubspace { point, directions } => {
            Arc::new(AffineSubspace::new(at(point), directions.iter().map(|x| at(x)))?)
        }
    })
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
