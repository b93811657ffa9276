//! `Shape`: a set as data, which can be written to a file and read by another program.

use std::{cmp::Ordering, sync::Arc};

use nalgebra::SVector;

use crate::{AxisBox, Ball, ClosedSet, HalfSpace, Point, proof};

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

    /// Returns whether `x` is a member, decided in exact arithmetic; false if a coordinate is not
    /// finite.
    ///
    /// ```
    /// use nalgebra::vector;
    /// use tautline_sets::{Ball, Shape};
    ///
    /// let ball = Shape::Ball(Ball::new([0.0, 0.0], 1.0)?);
    /// assert!(ball.contains(&vector![0.0, -1.0]));
    /// // x₁² + x₂² = 1 + 2⁻⁸⁰, which no double of this size is.
    /// assert!(!ball.contains(&vector![1.0, 0.5_f64.powi(40)]));
    /// # Ok::<(), tautline_sets::SetError>(())
    /// ```
    #[must_use]
    pub fn contains(&self, x: &SVector<f64, D>) -> bool {
        match self {
            Shape::Point(point) => point.position() == x,
            Shape::Ball(ball) => {
                proof::compare_distance(x, ball.centre(), ball.r()).is_some_and(Ordering::is_le)
            }
            Shape::AxisBox(side) => {
                (0..D).all(|i| side.lower()[i] <= x[i] && x[i] <= side.upper()[i])
            }
            Shape::HalfSpace(wall) => {
                let (n, b) = wall.given();
                proof::compare_height(n, x, b).is_some_and(Ordering::is_le)
            }
            Shape::Union(shapes) => shapes.iter().any(|shape| shape.contains(x)),
        }
    }

    /// Returns the shape of a union of sets; `None` if one of them has no shape.
    pub(crate) fn union(sets: &[Arc<dyn ClosedSet<D>>]) -> Option<Self> {
        sets.iter().map(|set| set.shape()).collect::<Option<_>>().map(Shape::Union)
    }
}
