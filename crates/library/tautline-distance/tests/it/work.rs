//! How much work known problems take. A proposal that is worse proves the same with more cubes.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_distance::Wanted;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    attempt::{attempt, holds},
    flat::{around, at_least, ball, formula, nearest, point},
};

/// Asserts that a gap is reached with at most so many cubes, and that they are not far too many.
fn takes<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curves: &[Vec<SVector<f64, D>>],
    d: f64,
    gap: f64,
    cubes: usize,
) {
    let found = attempt(formula, sets, curves, Wanted { gap, cubes }).expect("found");
    let used: usize = found.proved.levels.iter().map(|(cubes, _)| cubes).sum();
    println!("{used} of {cubes} {sets:?} {:?}", found.ended);
    holds(&found, d, 1e-9, gap);
}

fn flat_takes<const D: usize>(
    h: &SMatrix<f64, D, D>,
    sets: &[Shape<D>; 2],
    gap: f64,
    cubes: usize,
) {
    let pair = nearest(h, sets)[0].clone();
    takes(&formula(h), sets, &[pair.line(200)], pair.distance, gap, cubes);
}

/// The limits are about four thirds of what is used.
#[test]
fn sets_under_a_constant_metric_take_few_cubes() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let (x, y) = ([-1.5, -1.0], [1.25, 1.5]);
    flat_takes(&h, &[point(x), point(y)], 1e-4, 12_000);
    flat_takes(&h, &[ball(x, 0.5), ball(y, 0.75)], 1e-4, 13_500);
    flat_takes(&h, &[around(x, [0.5, 0.25]), around(y, [0.5, 0.25])], 1e-4, 8000);
    flat_takes(&h, &[point(x), around(y, [0.5, 0.25])], 1e-4, 9000);
}

/// Geodesics in two parts of the corridor, each with rays of its own.
#[test]
fn two_geodesics_take_few_cubes() {
    let (sets, curves) = crate::exchange::problem();
    let half_plane = Formula::<2>::parse("1/sqr(x2) I", &[]).expect("a formula");
    takes(&half_plane, &sets, &curves, 2_f64.ln(), 1e-4, 46_000);
}

/// The arc from `x` to `y` on the unit sphere, in stereographic coordinates.
fn arc(x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> f64 {
    let scale = ((1.0 + x.norm_squared()) * (1.0 + y.norm_squared())).sqrt();
    2.0 * ((x - y).norm() / scale).asin()
}

/// Far points of the sphere, and a wall: no tubes hold the short curves, but their own values do.
#[test]
fn regions_that_prove_themselves_take_few_cubes() {
    let sphere = Formula::<2>::parse("4/sqr(1 + x1^2 + x2^2) I", &[]).expect("a formula");
    let line = |a: f64, b: f64| {
        (0..=200).map(|n| vector![a + (b - a) * f64::from(n) / 200.0, 0.0]).collect::<Vec<_>>()
    };
    let (x, y) = (vector![-0.5, 0.0], vector![1.0, 0.0]);
    takes(&sphere, &[point(x), point(y)], &[line(-0.5, 1.0)], arc(&x, &y), 1e-3, 9500);
    // The wall is a circle through infinity, which is farther than its foot.
    let wall = at_least([1.0, 0.0], 0.25);
    takes(
        &sphere,
        &[point(x), wall],
        &[line(-0.5, 0.25)],
        2.0 * (0.5_f64.atan() + 0.25_f64.atan()),
        1e-3,
        6700,
    );
}

/// The gap is relative to the upper bound: what the first level proves is enough if no more is wanted.
#[test]
fn a_gap_that_the_first_level_has_takes_one_level() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let sets = [point([-1.5, -1.0]), point([1.25, 1.5])];
    let curve = nearest(&h, &sets)[0].line(20);
    let search = |gap: f64| {
        let curves = std::slice::from_ref(&curve);
        attempt(&formula(&h), &sets, curves, Wanted { gap, cubes: 50_000 }).expect("found").proved
    };
    let first = search(0.9);
    assert_eq!(first.levels.len(), 1);
    let gap = first.gap().expect("a curve");
    assert_eq!(search(gap * (1.0 + 1e-12)).levels.len(), 1);
    assert_eq!(search(gap * (1.0 - 1e-12)).levels.len(), 2);
}
