//! The sets of a problem: shapes in a dimension that is a value.

use std::{ops::Range, sync::Arc};

use tautline::{ANY, AnyEnds, SVector, SetError, Shape};

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

/// Returns the ends between two unions of shapes. Two points are recognised, since more is proved of them.
pub(crate) fn ends(from: Vec<Shape<ANY>>, to: Vec<Shape<ANY>>) -> Result<AnyEnds, SetError> {
    if let ([Shape::Point(from)], [Shape::Point(to)]) = (&from[..], &to[..]) {
        return AnyEnds::points(from.position_slice(), to.position_slice());
    }
    AnyEnds::new(Arc::new(joined(from)?), Arc::new(joined(to)?))
}

/// Returns the union of shapes, or the only one. The pieces of a union are single points, where they are
/// points, as in a [`Union`](tautline::Union): each has a ball of its own.
fn joined(shapes: Vec<Shape<ANY>>) -> Result<Shape<ANY>, SetError> {
    if shapes.len() == 1 {
        return Shape::union(shapes);
    }
    let single = |piece: &Shape<ANY>| match piece {
        Shape::FiniteSet(set) => set.points().iter().cloned().map(Shape::Point).collect(),
        piece => vec![piece.clone()],
    };
    let pieces = shapes.iter().flat_map(Shape::pieces).flat_map(single);
    Shape::union(pieces.collect())
}
