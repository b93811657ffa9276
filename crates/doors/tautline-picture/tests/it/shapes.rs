//! Sets to draw, from numbers that are right.

use tautline::{
    ANY, AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, Shape, Sphere,
};

pub(crate) fn point(x: &[f64]) -> Shape<ANY> {
    Shape::Point(Point::from_slice(x).expect("finite"))
}

pub(crate) fn points<const D: usize>(points: &[[f64; D]]) -> Shape<ANY> {
    Shape::FiniteSet(FiniteSet::from_slices(points).expect("finite"))
}

pub(crate) fn ball(centre: &[f64], r: f64) -> Shape<ANY> {
    Shape::Ball(Ball::from_slice(centre, r).expect("a radius"))
}

pub(crate) fn sphere(centre: &[f64], r: f64) -> Shape<ANY> {
    Shape::Sphere(Sphere::from_slice(centre, r).expect("a radius"))
}

pub(crate) fn axis_box(lower: &[f64], upper: &[f64]) -> Shape<ANY> {
    Shape::AxisBox(AxisBox::from_slices(lower, upper).expect("ordered"))
}

/// Returns the half-space `normal·x ≤ offset`.
pub(crate) fn half_space(normal: &[f64], offset: f64) -> Shape<ANY> {
    Shape::HalfSpace(HalfSpace::from_slice(normal, offset).expect("a normal"))
}

pub(crate) fn segment(start: &[f64], end: &[f64]) -> Shape<ANY> {
    Shape::Segment(Segment::from_slices(start, end).expect("finite"))
}

/// Returns the line through a point.
pub(crate) fn line(base: &[f64], direction: &[f64]) -> Shape<ANY> {
    Shape::AffineSubspace(AffineSubspace::from_slices(base, [direction]).expect("a direction"))
}
