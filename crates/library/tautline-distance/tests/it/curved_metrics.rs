//! Metrics that depend on the place, with distances in closed form.

use nalgebra::{SVector, matrix, vector};
use tautline_check::Region;
use tautline_distance::Wanted;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    attempt::{attempt, holds},
    flat::{around, at_least, ball, nearest, point},
};

fn check(text: &str, sets: [Shape<2>; 2], curve: Vec<SVector<f64, 2>>, d: f64, gap: f64) {
    let formula = Formula::<2>::parse(text, &[]).expect("a formula");
    let found = attempt(&formula, &sets, &[curve], Wanted { gap, cubes: 100_000 })
        .unwrap_or_else(|error| panic!("{text} {sets:?}: {error}"));
    holds(&found, d, 1e-9, gap);
}

const HALF_PLANE: &str = "1/sqr(x2) I";

/// In the half-plane, the distance of points on one vertical is the logarithm of the quotient of their
/// heights. Circles are circles about another centre: the one of this centre and radius has its lowest and
/// highest points at the heights `c ∓ r`, and the vertical between two balls is the shortest way.
#[test]
fn balls_in_the_half_plane_are_enclosed() {
    let curve = |low: f64, high: f64| {
        let height = |n: i32| low * (high / low).powf(f64::from(n) / 200.0);
        (0..=200).map(|n| vector![0.25, height(n)]).collect::<Vec<_>>()
    };
    let (low, high) = (ball([0.25, 1.0], 0.25), ball([0.25, 4.0], 1.0));
    check(HALF_PLANE, [low, high], curve(1.25, 3.0), 2.4_f64.ln(), 1e-3);
}

/// From a point at the distance `a` before the vertical `x₁ = 0` at the height 1, the circle about the
/// origin of the vertical meets it at a right angle, after the length `arsinh(a)`.
#[test]
fn a_box_and_a_vertical_wall_in_the_half_plane_are_enclosed() {
    let a: f64 = 0.75;
    let from = a.atan2(1.0);
    let radius = a.hypot(1.0);
    let arc = |n: i32| {
        let angle = from * (1.0 - f64::from(n) / 200.0);
        vector![-radius * angle.sin(), radius * angle.cos()]
    };
    let curve: Vec<_> = (0..=200).map(arc).collect();
    let d = a.asinh();
    // The foot is at the height 1.25, inside the side of the box.
    let side = around([0.5, 1.25], [0.5, 0.4]);
    for target in [side, at_least([1.0, 0.0], 0.0)] {
        check(HALF_PLANE, [point([-a, 1.0]), target], curve.clone(), d, 1e-3);
    }
}

/// With `s = (x₁ + A sin 2x₂, x₂)` and a constant metric `G` of `s`, the wall `x₂ ≥ b` is one in `s`
/// too. The nearest point of a set is its highest one, and the way to the wall is straight in `s`.
#[test]
fn a_full_matrix_that_depends_on_the_place_is_enclosed() {
    let g = matrix![2.0, 0.6; 0.6, 1.0];
    let root = g.cholesky().expect("definite").l().transpose();
    let text = format!(
        "pullback({}*(x1 + 0.3*sin(2*x2)) + {}*x2, {}*x2)",
        root[(0, 0)],
        root[(0, 1)],
        root[(1, 1)]
    );
    let wave = |x2: f64| 0.3 * (2.0 * x2).sin();
    let wall = at_least([0.0, 1.0], 1.25);
    let sets = [
        ball([-0.5, -0.75], 0.5),
        Shape::Union(vec![point([-0.5, -0.25]), ball([0.5, -1.0], 0.25)]),
        point([-0.5, -0.25]),
    ];
    for set in sets {
        let straight = nearest(&g, &[point([-0.5 + wave(-0.25), -0.25]), wall.clone()])[0].clone();
        let curve = straight.line(200).iter().map(|s| vector![s[0] - wave(s[1]), s[1]]).collect();
        check(&text, [set, wall.clone()], curve, straight.distance, 2e-3);
    }
}

/// The input that once stalled at a third of the distance, with a matrix that depends on the place: the
/// centres of both balls are nodes.
#[test]
fn two_balls_under_a_full_matrix_that_depends_on_the_place_reach_their_gap() {
    let text = "[1.2, 0.3 + 0.2*tanh(x1); 0.3 + 0.2*tanh(x1), 1.1]";
    let formula = Formula::<2>::parse(text, &[]).expect("a formula");
    let sets = [ball([-1.5, -1.0], 0.5), ball([1.25, 1.5], 0.75)];
    // A straight line is too long by about a hundredth.
    let curve = nearest(&matrix![1.2, 0.3; 0.3, 1.1], &sets)[0].line(200);
    let found = attempt(&formula, &sets, &[curve], Wanted { gap: 3e-2, cubes: 20_000 });
    let proved = found.expect("found").proved;
    assert!(proved.gap().is_some_and(|gap| gap <= 3e-2), "{:?}", proved.levels);
}

/// Curves end where they meet a large set, and the first level need not go beyond, but it has to go into it:
/// otherwise a curve might leave the cubes in front of it. Here the cost `exp(−x₁)` falls behind the wall, so
/// that no ball around the point holds short curves, and only the wall stops them. To the wall `x₁ = w` the
/// distance is `1 − exp(−w)`.
#[test]
fn the_first_level_reaches_into_a_large_set() {
    let formula = Formula::<3>::parse("cost(exp(-x1))", &[]).expect("a formula");
    // The cubes have the side 1/8. The last ones before the wall are in front of it, and the ball around
    // each reaches behind it: the wall is 0.55 sides from their centres.
    let w: f64 = 1.0 + 0.05 / 8.0;
    let first_level = |target: Shape<3>| {
        let curve: Vec<_> = (0..=20).map(|n| vector![w * f64::from(n) / 20.0, 0.0, 0.0]).collect();
        let sets = [point([0.0; 3]), target];
        let wanted = Wanted { gap: 0.5, cubes: 60_000 };
        let found = attempt(&formula, &sets, &[curve], wanted).expect("a region");
        assert_eq!(found.certificate.region, Region::ExitOne);
        holds(&found, 1.0 - (-w).exp(), 1e-3, 0.5);
        found.certificate.levels[0].cubes().clone()
    };
    let (wall, far) = (at_least([1.0, 0.0, 0.0], w), ball([-9.0, 0.0, 0.0], 0.5));
    let alone = first_level(wall.clone());
    // Another piece far away changes nothing: no more cubes lie behind the wall.
    assert_eq!(first_level(Shape::Union(vec![far, wall])), alone);
}
