//! Fans whose distances are known.

use nalgebra::{SVector, vector};
use tautline_formula::Formula;
use tautline_sets::{Point, Shape};

use super::{Fan, Pencil};
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
