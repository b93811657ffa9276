//! Fans whose distances are known.

use nalgebra::{SVector, vector};
use tautline_formula::Formula;
use tautline_sets::{AxisBox, Ball, Point, Shape};

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
    let behind = pencil.focus;
    // As far away as the rays reach.
    let points = within(0.4, behind);
    let rays = pencil.covering(0, 6, &points, (1.1, 400));
    let fan = Fan::new(&flat, &sets[0], &geodesic, 0, &rays).expect("rays");
    for at in &points {
        let exact = (at[0] + behind).hypot(at[1]) - behind;
        let error = |value: f64| (value - exact).abs();
        let (many, one) = (error(fan.value(at)), error(fan.value_near(at)));
        assert!(many < 1e-5 && many < one / 20.0, "{at} {many:e} {one:e}");
    }
}

/// Returns points that are seen from `behind` the origin up to this slope.
fn within(slope: f64, behind: f64) -> Vec<SVector<f64, 2>> {
    let of = |x: f64| [-1.0, -0.5, 0.3, 0.8].map(|part| vector![x, part * slope * (x + behind)]);
    [0.0, 0.2, 0.5, 0.9].into_iter().flat_map(of).collect()
}

/// A fan from a ball is the distance from the sphere that touches it there and is as curved as its front,
/// also far from the geodesic: from the ball itself if that is large, and else from one around it.
#[test]
fn many_rays_from_a_ball_are_the_distance_from_one_sphere() {
    let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
    let point = Shape::Point(Point::new([1.0, 0.0]).expect("finite"));
    let curve = [vector![0.0, 0.0], vector![1.0, 0.0]];
    let geodesic = Geodesic::near(&flat, &curve).expect("a geodesic");
    for r in [0.05, 0.5] {
        let ball = Shape::Ball(Ball::new([-r, 0.0], r).expect("a radius"));
        let sets = [ball, point.clone()];
        let pencil = Pencil::along(&flat, &sets, &geodesic, 400).expect("rays");
        let radius = r.max(pencil.focus);
        let points = within(0.4, radius);
        let fan = pencil.wide((&flat, &sets[0]), &geodesic, 0, 6, &points).expect("rays");
        for at in &points {
            let exact = (at[0] + radius).hypot(at[1]) - radius;
            let error = |value: f64| (value - exact).abs();
            let (many, one) = (error(fan.value(at)), error(fan.value_near(at)));
            assert!(many < 1e-5 && many < one / 20.0, "{r} {at} {many:e} {one:e}");
        }
    }
}

/// Points that lie far from the geodesic along one tangent only get rays along this tangent.
#[test]
fn rays_are_as_far_apart_along_each_tangent_as_its_points_need() {
    let flat = Formula::<3>::parse("1 I", &[]).expect("a formula");
    let sets = [[0.0; 3], [1.0, 0.0, 0.0]].map(|x| Shape::Point(Point::new(x).expect("finite")));
    let curve = [vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0]];
    let geodesic = Geodesic::near(&flat, &curve).expect("a geodesic");
    let pencil = Pencil::along(&flat, &sets, &geodesic, 400).expect("rays");
    let strip = (-20..=20).flat_map(|y| [-0.02, 0.0, 0.02].map(|z| (f64::from(y) / 40.0, z)));
    let points: Vec<SVector<f64, 3>> = strip.map(|(y, z)| vector![1.0, y, z]).collect();
    let rays = pencil.covering(0, 5, &points, (1.1, 100));
    // The steps are as the widths, 0.5 and 0.02, up to the order of the tangents.
    let ratio = rays.spacing[0].max(rays.spacing[1]) / rays.spacing[0].min(rays.spacing[1]);
    assert!((ratio - 25.0).abs() < 0.1, "{}", rays.spacing);
    // At most five on each side and those whose values still count there.
    assert!(rays.lattice.len() < 13 * 13, "{}", rays.lattice.len());
    let fan = Fan::new(&flat, &sets[0], &geodesic, 0, &rays).expect("rays");
    for x in &points {
        let focus = vector![-pencil.focus, 0.0, 0.0];
        let exact = (x - focus).norm() - pencil.focus;
        assert!((fan.value(x) - exact).abs() < 1e-4, "{x} {}", fan.value(x) - exact);
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

/// A ball of radius 0 is a point, alone or in a union: its sphere has no normal.
#[test]
fn rays_leave_a_ball_of_radius_0_as_they_leave_a_point() {
    let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
    let ends = [vector![0.0, 0.0], vector![1.0, 0.5]];
    let [from, to] = ends.map(|x| Shape::Point(Point::new(x).expect("finite")));
    let ball = Shape::Ball(Ball::new(ends[0], 0.0).expect("a radius"));
    let union = Shape::Union(vec![side([-3.0, -3.0], [-2.0, -2.0]), ball.clone()]);
    let geodesic = Geodesic::near(&flat, &ends).expect("a geodesic");
    let values = |from: Shape<2>| {
        let pencil = Pencil::along(&flat, &[from, to.clone()], &geodesic, 400).expect("rays");
        let at = |t: f64| pencil.fans[0].value_near(&vector![t, 0.5 * t + 0.05]);
        [0.1, 0.5, 0.9].map(at)
    };
    let expected = values(from);
    assert!(expected.iter().all(|value| *value > 0.0), "{expected:?}");
    assert_eq!([values(ball), values(union)], [expected; 2]);
}
