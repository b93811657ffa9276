//! Fans whose distances are known.

use nalgebra::{SVector, vector};
use tautline_formula::Formula;
use tautline_sets::{AxisBox, Point, Shape};

use super::{End, Fan, Pencil};
use crate::geodesic::Geodesic;

/// In the Euclidean plane, a fan of rays from a focus behind the origin is the distance from the
/// focus. Between rays the error is of fourth order in their distance; a single ray has one of
/// fourth order in the distance from it, which is up to six times as large.
#[test]
fn many_rays_are_accurate_far_from_the_geodesic() {
    let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
    let sets = [[0.0, 0.0], [1.0, 0.0]].map(|x| Shape::Point(Point::new(x).expect("finite")));
    let curve: Vec<SVector<f64, 2>> = (0..=10).map(|n| vector![f64::from(n) / 10.0, 0.0]).collect();
    let geodesic = Geodesic::near(&flat, &curve).expect("a geodesic");
    let pencil = Pencil::along(&flat, &sets, &geodesic, 400).expect("rays");
    let rays = pencil.covering(0, 6, &[vector![0.0, 0.1], vector![1.0, -0.2]], (1.1, 400));
    let fan = Fan::new(&flat, &sets[0], &geodesic, 0, rays).expect("rays");
    let behind = pencil.focus;
    for x in [0.0, 0.2, 0.5, 0.9] {
        for part in [-0.9, -0.5, 0.3, 0.8] {
            // As far away as the rays reach.
            let at = vector![x, part * 0.4 * (x + behind)];
            let exact = (x + behind).hypot(at[1]) - behind;
            let error = |value: f64| (value - exact).abs();
            let (many, one) = (error(fan.value(&at)), error(fan.value_near(&at)));
            assert!(many < 1e-5 && many < one / 20.0, "{at} {many:e} {one:e}");
        }
    }
}

fn side(lower: [f64; 2], upper: [f64; 2]) -> Shape<2> {
    Shape::AxisBox(AxisBox::from_corners(lower, upper).expect("corners"))
}

/// Between two faces there is a whole strip of geodesics, and no function is convex across all of them; one
/// end that is curved is enough, whichever it is.
#[test]
fn rays_leave_faces_and_corners_of_boxes() {
    let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
    let along = |sets: &[Shape<2>; 2], ends: [SVector<f64, 2>; 2]| {
        let geodesic = Geodesic::near(&flat, &ends).expect("a geodesic");
        Pencil::along(&flat, sets, &geodesic, 400)
    };
    let face = side([-1.0, -1.0], [0.0, 1.0]);
    let point = Shape::Point(Point::new([1.0, 0.0]).expect("finite"));
    let ends = [vector![0.0, 0.0], vector![1.0, 0.0]];
    assert!(along(&[face.clone(), point.clone()], ends).is_some());
    assert!(along(&[point, face.clone()], [ends[1], ends[0]]).is_some());
    let opposite = side([1.0, -1.0], [2.0, 1.0]);
    assert!(along(&[face, opposite], ends).is_none());
    // From corner to corner there is one, with fronts that touch the boxes from outside.
    let corners = [side([-1.0, -1.0], [0.0, 0.0]), side([1.0, 0.5], [2.0, 2.0])];
    let pencil = along(&corners, [vector![0.0, 0.0], vector![1.0, 0.5]]).expect("rays");
    for (fan, x) in pencil.fans.iter().zip([vector![-0.02, 0.0], vector![1.02, 0.5]]) {
        assert!(fan.value_near(&x) < 0.0, "{}", fan.value_near(&x));
    }
}

/// A front that leaves a ball is as curved as its sphere, but no more than one that leaves a point.
#[test]
fn a_front_from_a_small_ball_is_no_more_curved_than_one_from_a_point() {
    let curved = |r: f64| {
        let (x, p) = (vector![r, 0.0], vector![1.0, 0.0]);
        End::Ball(vector![0.0, 0.0]).bend(&x, &p, 0.25)[(1, 1)]
    };
    assert_eq!((curved(0.5), curved(0.01)), (2.0, 4.0));
    // Across a face nothing is.
    let bend = End::<2>::Box.bend(&vector![0.0, 0.0], &vector![1.0, 0.01], 0.25);
    assert_eq!((bend[(0, 0)], bend[(1, 1)]), (4.0, 0.0));
}
