//! `Shape`: a set as data, which can be written to a file and read by another program.

use std::sync::Arc;

use crate::{AxisBox, Ball, ClosedSet, HalfSpace, Point};

/// A set that is described by finitely many numbers: one piece, or the union of several.
///
/// The numbers define the set exactly, as those of [`ClosedSet::member_near`] do.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape<const D: usize> {
    /// One point.
    Point(Point<D>),
    /// A ball.
    Ball(Ball<D>),
    /// A box with sides parallel to the axes.
    AxisBox(AxisBox<D>),
    /// A half-space.
    HalfSpace(HalfSpace<D>),
    /// The union of shapes.
    Union(Vec<Shape<D>>),
}

impl<const D: usize> Shape<D> {
    /// Returns the pieces, none of which is a union, in order.
    #[must_use]
    pub fn pieces(&self) -> Vec<&Self> {
        match self {
            Shape::Union(shapes) => shapes.iter().flat_map(Shape::pieces).collect(),
            piece => vec![piece],
        }
    }

    /// Returns the shape of a union of sets; `None` if one of them has no shape.
    pub(crate) fn union(sets: &[Arc<dyn ClosedSet<D>>]) -> Option<Self> {
        sets.iter().map(|set| set.shape()).collect::<Option<_>>().map(Shape::Union)
    }
}
