//! Constant metrics with entries beside the diagonal: all kinds of sets, in both orders.

use nalgebra::{SMatrix, SVector, matrix};
use tautline_chance::{Random, cases, seed};
use tautline_distance::Wanted;
use tautline_sets::Shape;

use crate::{
    attempt::{attempt, holds},
    flat::{around, at_least, ball, formula, full_matrix, nearest, point},
};

/// Asserts that the distance is enclosed with this gap, with the sets in this order or in the other one.
fn check<const D: usize>(
    h: &SMatrix<f64, D, D>,
    sets: &[Shape<D>; 2],
    is_turned: bool,
    (gap, cubes): (f64, usize),
) {
    // Further curves help if they are nearly as short.
    let pairs = nearest(h, sets);
    let d = pairs[0].distance;
    let near = pairs.iter().filter(|pair| pair.distance < 1.1 * d);
    let mut curves: Vec<_> = near.map(|pair| pair.line(20)).collect();
    let mut sets = sets.clone();
    if is_turned {
        sets.reverse();
        curves.iter_mut().for_each(|curve| curve.reverse());
    }
    let found = attempt(&formula(h), &sets, &curves, Wanted { gap, cubes })
        .unwrap_or_else(|error| panic!("{h} {sets:?}: {error}"));
    holds(&found, d, 1e-11, gap);
}

/// Returns sets around a place of every kind, bounded ones first.
fn kinds<const D: usize>(x: SVector<f64, D>, r: f64) -> Vec<Shape<D>> {
    let far = x * 1.5;
    vec![
        point(x),
        ball(x, r),
        around(x, SVector::from_fn(|i, _| r * (1.0 - 0.2 * i as f64))),
        Shape::Union(vec![point(x), point(far)]),
        Shape::Union(vec![ball(far, r), around(x, SVector::from_element(0.5 * r))]),
        Shape::Union(vec![ball(far, r), point(x), at_least(x, 2.0 * x.norm_squared())]),
        at_least(x, x.norm_squared()),
    ]
}

/// All pairs of kinds of which one is bounded, at these two places.
fn pairs<const D: usize>(h: &SMatrix<f64, D, D>, places: [SVector<f64, D>; 2], gap: f64) {
    let [first, second] = places.map(|x| kinds(x, 0.5));
    for (n, a) in first[..5].iter().enumerate() {
        for (m, b) in second.iter().enumerate() {
            // Each kind comes first and second, and each pair in one of the dimensions.
            if (n + m + D).is_multiple_of(2) {
                check(h, &[a.clone(), b.clone()], n > m, (gap, 50_000));
            }
        }
    }
}

#[test]
fn all_pairs_of_sets_are_enclosed_on_a_line() {
    pairs(&matrix![2.5], [[-1.5].into(), [1.25].into()], 1e-3);
}

#[test]
fn all_pairs_of_sets_are_enclosed_in_the_plane() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    // Centres that are nodes of the lattice, and such that are not.
    pairs(&h, [[-1.5, -1.0].into(), [1.25, 1.5].into()], 3e-2);
}

#[test]
fn some_pairs_of_sets_are_enclosed_in_space() {
    let h = matrix![1.2, 0.4, 0.1; 0.4, 1.1, -0.3; 0.1, -0.3, 1.4];
    let [first, second] = [[-1.5, -1.0, 0.5], [1.25, 1.5, -0.7]].map(|x| kinds(x.into(), 0.5));
    for (a, b) in [(2, 1), (4, 5)] {
        check(&h, &[first[a].clone(), second[b].clone()], b == 1, (0.3, 10_000));
    }
}

/// In four dimensions the march knows the diagonal of `H⁻¹` only, but the rays know all.
#[test]
fn a_ball_and_a_box_are_enclosed_in_four_dimensions() {
    let h = SMatrix::<f64, 4, 4>::from_fn(|i, j| if i == j { 1.0 } else { 0.1 });
    let sets =
        [ball([-0.8, -0.5, 0.1, 0.0], 0.5), around([0.9, 0.6, 0.3, -0.5], [0.4, 0.3, 0.5, 0.2])];
    check(&h, &sets, false, (0.7, 3000));
}

/// The centre of a ball may be a node of the lattice: there no direction leads away from it.
fn random_matrices<const D: usize>(fixed: u64, count: u32, gap: f64) {
    let mut random = Random(seed(fixed));
    for n in 0..cases(count) {
        let h = full_matrix::<D>(&mut random);
        let mut place = |sign: f64| -> SVector<f64, D> {
            SVector::from_fn(|_, _| {
                let x = sign * random.between(0.9, 1.5);
                if n % 2 == 0 { (8.0 * x).round() / 8.0 } else { x }
            })
        };
        let (x, y) = (place(-1.0), place(1.0));
        let target = ball(y, 0.75);
        let wall = at_least(y, y.norm_squared());
        let limits = (gap, 100_000);
        check(&h, &[ball(x, 0.5), target.clone()], false, limits);
        if D > 2 {
            continue;
        }
        check(&h, &[around(x, SVector::from_element(0.4)), target.clone()], true, limits);
        check(&h, &[Shape::Union(vec![point(x), point(x * 1.25)]), target], n % 2 == 0, limits);
        check(&h, &[Shape::Union(vec![point(x), ball(x * 1.25, 0.25)]), wall], n % 2 == 1, limits);
    }
}

#[test]
fn random_full_matrices_are_enclosed_in_the_plane() {
    random_matrices::<2>(21, 3, 1e-3);
}

#[test]
fn random_full_matrices_are_enclosed_in_space() {
    random_matrices::<3>(22, 1, 0.2);
}

/// What lies between the sets decides how much work there is, not what the sets are: two balls, or a box
/// and a ball, take no more cubes than twice those between their nearest points.
#[test]
fn balls_and_boxes_cost_no_more_than_twice_the_points() {
    let mut random = Random(seed(23));
    let two_balls = [ball([-1.5, -1.0], 0.5), ball([1.25, 1.5], 0.75)];
    let mut all: Vec<_> =
        (0..cases(2)).map(|_| (full_matrix::<2>(&mut random), two_balls.clone())).collect();
    // Across the way, short curves are many times as far apart as the ball is wide.
    let stretched = matrix![1.924, 1.334; 1.334, 1.963];
    all.push((stretched, [around([-1.55, -1.05], [0.35, 0.35]), ball([1.25, 1.5], 0.315)]));
    for (h, sets) in all {
        let curve = nearest(&h, &sets)[0].line(20);
        let formula = formula(&h);
        let cubes = |sets: &[Shape<2>; 2]| {
            let found = attempt(&formula, sets, std::slice::from_ref(&curve), Wanted::gap(1e-3))
                .expect("found");
            holds(&found, nearest(&h, sets)[0].distance, 1e-11, 1e-3);
            found.proved.levels.iter().map(|(cubes, _)| cubes).sum::<usize>()
        };
        let points = cubes(&[point(curve[0]), point(curve[20])]);
        let balls = cubes(&sets);
        assert!(balls <= 2 * points, "{balls} after {points} for {h}");
    }
}
