//! The closed sets of the project, one line each, and one of one's own.

use std::sync::Arc;

use tautline::{
    AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, Sphere, Union,
};
use tautline_kit::prelude::*;

use crate::own::Ellipse;

fn cube<const D: usize>() -> Region<D> {
    Region::cell([-4.0; D], [4.0; D])
}

fn point() -> Point<2> {
    Point::new([1.0, -0.5]).expect("finite")
}

fn finite_set() -> FiniteSet<2> {
    FiniteSet::new([[1.0, 0.0], [-2.0, 1.0], [0.5, -2.0]]).expect("three points")
}

fn ball() -> Ball<3> {
    Ball::new([0.5, -1.0, 0.3], 1.5).expect("a radius")
}

fn sphere() -> Sphere<3> {
    Sphere::new([0.5, -1.0, 0.3], 1.5).expect("a radius")
}

fn axis_box() -> AxisBox<2> {
    AxisBox::new([0.5, -1.0], [1.0, 2.0]).expect("half-widths")
}

fn interval() -> AxisBox<1> {
    AxisBox::new([0.5], [1.0]).expect("a half-width")
}

fn segment() -> Segment<2> {
    Segment::new([-1.0, -2.0], [2.0, 1.0]).expect("finite")
}

fn half_space() -> HalfSpace<2> {
    HalfSpace::new([1.0, 2.0], 0.5).expect("a normal")
}

fn line() -> AffineSubspace<3> {
    AffineSubspace::new([0.5, 0.0, 1.0], [[1.0, 2.0, 0.0]]).expect("a direction")
}

fn union() -> Union<2> {
    let members: Vec<Arc<dyn ClosedSet<2>>> = vec![
        Arc::new(Ball::new([-1.5, 0.5], 1.0).expect("a radius")),
        Arc::new(Segment::new([1.0, -1.0], [2.0, 2.0]).expect("finite")),
        Arc::new(Point::new([0.0, -3.0]).expect("finite")),
    ];
    Union::new(members).expect("three members")
}

set_suite!(a_point: point(), dimension 2, in cube());
set_suite!(a_finite_set: finite_set(), dimension 2, in cube());
set_suite!(a_ball: ball(), dimension 3, in cube());
set_suite!(a_sphere: sphere(), dimension 3, in cube());
set_suite!(a_box: axis_box(), dimension 2, in cube());
set_suite!(an_interval: interval(), dimension 1, in cube());
set_suite!(a_segment: segment(), dimension 2, in cube());
set_suite!(a_half_space: half_space(), dimension 2, in cube());
set_suite!(an_affine_subspace: line(), dimension 3, in cube());
set_suite!(a_union: union(), dimension 2, in cube());
set_suite!(an_ellipse: Ellipse::new([0.3, -0.4], [1.2, 0.4], 0.6), dimension 2, in cube());
