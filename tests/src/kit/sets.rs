//! Runs the kit on the closed sets of the project, and on a closed set that a user wrote.

use std::sync::Arc;

use tautline::{
    AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, SetError, Shape, Sphere,
    Union,
};
use tautline_kit::prelude::*;

use crate::own::Ellipse;

fn cube<const D: usize>() -> Region<D> {
    Region::cell([-4.0; D], [4.0; D])
}

fn union() -> Union<2> {
    let members: Vec<Arc<dyn ClosedSet<2>>> = vec![
        Arc::new(Ball::new([-1.5, 0.5], 1.0).expect("a radius")),
        Arc::new(Segment::new([1.0, -1.0], [2.0, 2.0]).expect("finite")),
        Arc::new(Point::new([0.0, -3.0]).expect("finite")),
    ];
    Union::new(members).expect("three members")
}

fn shape() -> Result<Shape<2>, SetError> {
    let corners = AxisBox::from_corners([1.0, -1.0], [2.0, 2.0])?;
    Shape::union(vec![
        Shape::Sphere(Sphere::new([-1.5, 0.5], 1.0)?),
        Shape::AxisBox(corners),
        Shape::FiniteSet(FiniteSet::new([[0.0, -3.0], [-3.0, -2.0]])?),
    ])
}

macro_rules! suites {
    ($($name:ident, $d:literal, $set:expr;)*) => {
        $(set_suite!($name: $set.expect("valid"), dimension $d, in cube());)*
    };
}

suites! {
    a_point, 2, Point::new([1.0, -0.5]);
    a_finite_set, 2, FiniteSet::new([[1.0, 0.0], [-2.0, 1.0], [0.5, -2.0]]);
    a_ball, 3, Ball::new([0.5, -1.0, 0.3], 1.5);
    a_sphere, 3, Sphere::new([0.5, -1.0, 0.3], 1.5);
    a_box, 2, AxisBox::new([0.5, -1.0], [1.0, 2.0]);
    an_interval, 1, AxisBox::new([0.5], [1.0]);
    a_segment, 2, Segment::new([-1.0, -2.0], [2.0, 1.0]);
    a_half_space, 2, HalfSpace::new([1.0, 2.0], 0.5);
    a_shape, 2, shape();
    an_affine_subspace, 3, AffineSubspace::new([0.5, 0.0, 1.0], [[1.0, 2.0, 0.0]]);
}

set_suite!(a_union: union(), dimension 2, in cube());
set_suite!(an_ellipse: Ellipse::new([0.3, -0.4], [1.2, 0.4], 0.6), dimension 2, in cube());
