//! The closed sets of the project, one line each, and one of one's own.

use std::sync::Arc;

use tautline::{
    AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, Sphere, Union,
};
use tautline_verify::prelude::*;

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

set_suite!(point: Point::new([1.0, -0.5]).expect("finite"), dimension 2, in cube());
set_suite!(finite_set: FiniteSet::new([[1.0, 0.0], [-2.0, 1.0], [0.5, -2.0]]).expect("finite"), dimension 2, in cube());
set_suite!(ball: Ball::new([0.5, -1.0, 0.3], 1.5).expect("a radius"), dimension 3, in cube());
set_suite!(sphere: Sphere::new([0.5, -1.0, 0.3], 1.5).expect("a radius"), dimension 3, in cube());
set_suite!(axis_box: AxisBox::new([0.5, -1.0], [1.0, 2.0]).expect("half-widths"), dimension 2, in cube());
set_suite!(segment: Segment::new([-1.0, -2.0], [2.0, 1.0]).expect("finite"), dimension 2, in cube());
set_suite!(half_space: HalfSpace::new([1.0, 2.0], 0.5).expect("a normal"), dimension 2, in cube());
set_suite!(affine_subspace: AffineSubspace::new([0.5, 0.0, 1.0], [[1.0, 2.0, 0.0]]).expect("a line"), dimension 3, in cube());
set_suite!(union_of_three: union(), dimension 2, in cube());
set_suite!(interval: AxisBox::new([0.5], [1.0]).expect("half-widths"), dimension 1, in cube());
set_suite!(ellipse: Ellipse::new([0.3, -0.4], [1.2, 0.4], 0.6), dimension 2, in cube());
