//! The ends of a problem, from shapes.

use std::sync::Arc;

use tautline::{ANY, AnyEnds, SVector, SetError, Shape};

/// Returns the first `D` coordinates.
#[must_use]
pub fn vector<const D: usize>(x: &[f64]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or(0.0))
}

/// Returns the ends between two unions of shapes. Two points are recognised, since more is proved of them.
///
/// # Errors
///
/// [`SetError`].
pub fn ends(from: Vec<Shape<ANY>>, to: Vec<Shape<ANY>>) -> Result<AnyEnds, SetError> {
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
    Shape::union(shapes.iter().flat_map(Shape::single_pieces).collect())
}
