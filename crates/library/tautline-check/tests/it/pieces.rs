//! Values on sets of several pieces, and on sets that touch a simplex.

use nalgebra::SVector;
use tautline_check::{AnyCertificate, Region};
use tautline_sets::{Ball, HalfSpace, Shape};

use crate::helpers::{Function, axis_box, formula, on_cubes, one_level, point, proves_at_most};

const REGION: Region = Region::Declared { c1: 1.0 };

/// Two points lie in one simplex. `φ` counts from the one where it is larger.
#[test]
fn all_pieces_in_a_simplex_count() {
    for order in [[0.25, 0.75], [0.75, 0.25]] {
        let from = Shape::Union(order.map(|x| point([x])).to_vec());
        let sets = [from, point([3.5])];
        let certificate = one_level(formula("1 I"), sets, 3.0, REGION, 0, [&|x| x[0], &|x| -x[0]]);
        proves_at_most(&certificate.check(), 2.75);
    }
}

/// The second set is a side of cubes.
#[test]
fn a_set_that_touches_a_simplex_meets_it() {
    let sets = [point([0.5]), axis_box([2.0], [2.0])];
    let certificate = one_level(formula("1 I"), sets, 3.0, REGION, 0, [&|x| x[0], &|x| -x[0]]);
    proves_at_most(&certificate.check(), 1.5);
}

/// Returns `∫ √(1 + 9x²) dx` from 0.15 to 0.3.
fn length_of_the_bend() -> f64 {
    let primitive = |x: f64| 0.5 * x * (1.0 + 9.0 * x * x).sqrt() + (3.0 * x).asinh() / 6.0;
    primitive(0.3) - primitive(0.15)
}

/// `H` bends so much that the vertex test fails at one corner of the cube and not at the other. The
/// bound on the whole cube takes its place at both.
#[test]
fn a_vertex_test_that_fails_at_a_corner_fails_on_the_cube() {
    let phi = |x: &SVector<f64, 1>| 2.78 * (0.3 * x[0] + 0.35 * x[0] * x[0]);
    let sets = [point([0.15]), point([0.3])];
    let metric = "(1 + 9*sqr(x1)) I";
    let found = on_cubes(metric, sets, 0.2, REGION, 0, &[[0]], [&phi, &|x| -phi(x)]);
    assert!(found.is_ok(), "{found:?}");
    proves_at_most(&found, length_of_the_bend());
}

/// The same with the cube turned round: `H` is least at the last corner, and the first one says nothing of
/// it.
#[test]
fn where_the_vertex_test_fails_all_of_the_cube_counts() {
    let phi = |x: &SVector<f64, 1>| 2.78 * (0.3 * (1.0 - x[0]) + 0.35 * (1.0 - x[0]).powi(2));
    let sets = [point([0.85]), point([0.7])];
    let metric = "(1 + 9*sqr(1 - x1)) I";
    let found = on_cubes(metric, sets, 0.2, REGION, 0, &[[0]], [&phi, &|x| -phi(x)]);
    assert!(found.is_ok(), "{found:?}");
    proves_at_most(&found, length_of_the_bend());
    // H is 10 at both corners, and no corner says anything of the middle, where it is 1.
    let sets = [point([0.25]), point([0.75])];
    let metric = "(1 + 144*(x1 - 0.5)^4) I";
    let found = on_cubes(metric, sets, 0.9, REGION, 0, &[[0]], [&|x| x[0], &|x| -x[0]]);
    assert!(found.is_ok(), "{found:?}");
    // √(1 + 144u⁴) ≤ 1 + 72u⁴, whose integral over |u| ≤ 1/4 is below 0.5282.
    proves_at_most(&found, 0.5282);
}

#[test]
fn pieces_of_all_kinds_are_read_as_they_were_written() {
    let ball = Shape::Ball(Ball::new([3.0, 0.0], 0.25).expect("a radius"));
    let wall = Shape::HalfSpace(HalfSpace::at_least([1.0, 0.5], 3.0).expect("a normal"));
    let from = Shape::Union(vec![point([0.5, 0.0]), axis_box([0.0, -0.5], [0.25, 0.0])]);
    let to = Shape::Union(vec![ball, wall, point([3.5, 0.0])]);
    let functions: [Function<'_, 2>; 2] = [&|x| x[0], &|x| 3.5 - x[0]];
    let certificate = one_level(formula("1 I"), [from, to], 4.0, REGION, -2, functions);
    let read = AnyCertificate::read(&certificate.to_string());
    assert_eq!(read, Ok(AnyCertificate::Plane(certificate)));
}
