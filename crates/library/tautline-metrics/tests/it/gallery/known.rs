//! Which pairs have a known distance: edge cases, and the order of the points.

use nalgebra::{SVector, vector};
use tautline_metrics::{
    KnownDistance,
    gallery::{Checkerboard, Corrugated, EggCrate, HyperbolicPatch, Lens, SpherePatch, Valleys},
};

/// Checks all pairs of the points: the distance is known in both directions or in neither, it is
/// symmetric, and it is 0 only from a point to itself.
#[track_caller]
fn is_symmetric<const D: usize>(g: &impl KnownDistance<D>, points: &[SVector<f64, D>]) {
    for (x, y) in points.iter().flat_map(|x| points.iter().map(move |y| (x, y))) {
        match (g.distance(x, y), g.distance(y, x)) {
            // The two values are quadratures, or sums, of the same terms.
            (Some(there), Some(back)) => {
                assert!((there - back).abs() <= 1e-13 * there, "{x} {y}: {there} {back}");
                assert_eq!(there == 0.0, x == y, "{x} {y}: {there}");
            }
            (there, back) => assert_eq!(there, back, "{x} {y}"),
        }
    }
}

#[test]
fn a_distance_is_known_both_ways_or_not_at_all() {
    let board = Checkerboard::new(2.0, 0.5).expect("positive");
    // Two points lie on the line x₁ = ½, two on x₂ = 1, and two on neither.
    let on = [vector![0.5, 0.3], vector![0.5, 2.2], vector![0.1, 1.0], vector![-3.3, 1.0]];
    let off = [vector![0.3, 0.3], vector![0.7, 0.1]];
    is_symmetric(&board, &[&on[..], &off[..]].concat());
    let known = |x, y| board.distance(x, y).is_some();
    assert!(known(&on[0], &on[1]) && known(&on[2], &on[3]) && known(&off[0], &off[0]));
    assert!(!known(&on[0], &off[0]) && !known(&off[0], &on[0]) && !known(&on[0], &on[2]));
    let inside = [vector![0.5, 0.0], vector![0.0, -0.5], vector![0.1, 0.2], vector![0.0, 0.0]];
    let outside = [vector![0.5_f64.next_up(), 0.0], vector![0.4, 0.4], vector![9.0, 0.0]];
    let both = [&inside[..], &outside[..]].concat();
    is_symmetric(&HyperbolicPatch::new(0.5).expect("positive"), &both);
    is_symmetric(&SpherePatch::new(0.5).expect("positive"), &both);
    is_symmetric(&Lens::new(2.0, 0.7).expect("positive"), &both);
    is_symmetric(&Valleys, &both);
    is_symmetric(&Corrugated::new(0.7, 1.3).expect("k > 0"), &both);
    // Points on the line x₁ + x₂ = 0, where the height vanishes, and points off it.
    let flat = [vector![0.3, -0.3], vector![-1.1, 1.1]];
    let eggs = EggCrate::new(0.7, 1.3).expect("k > 0");
    is_symmetric(&eggs, &[&flat[..], &both[..]].concat());
    assert!(eggs.distance(&flat[0], &flat[1]).is_some());
    assert_eq!(eggs.distance(&flat[0], &vector![0.1, 0.2]), None);
}

#[test]
fn the_rim_of_a_patch_belongs_to_it() {
    let rim = [vector![0.5, 0.0], vector![0.0, 0.5], vector![-0.5, 0.0], vector![0.0, -0.5]];
    let hyperbolic = HyperbolicPatch::new(0.5).expect("positive");
    let sphere = SpherePatch::new(0.5).expect("positive");
    let beyond = vector![0.0, 0.5_f64.next_up()];
    for x in rim {
        for y in [vector![0.0, 0.0], x, -x, vector![x[1], x[0]]] {
            assert!(hyperbolic.distance(&x, &y).is_some(), "{x} {y}");
            assert!(sphere.distance(&x, &y).is_some(), "{x} {y}");
        }
        assert_eq!((hyperbolic.distance(&x, &beyond), sphere.distance(&x, &beyond)), (None, None));
    }
}

/// The tolerance of a grid line is the rounding of its coordinate, in every unit.
#[test]
fn points_on_a_grid_line_are_recognised_in_every_unit() {
    for unit in [1e-20, 1.0, 1e9] {
        let board = Checkerboard::new(2.0, 0.1 * unit).expect("positive");
        // 3 · 0.1 is not 0.3 in floating point.
        let (x, y) = (vector![0.3 * unit, 0.02 * unit], vector![0.3 * unit, 0.57 * unit]);
        let d = board.distance(&x, &y).expect("on a line");
        assert!((d - 0.55 * unit).abs() <= 1e-15 * unit);
        let beside = vector![0.3 * (1.0 + 1e-12) * unit, 0.57 * unit];
        assert_eq!((board.distance(&x, &beside), board.distance(&beside, &x)), (None, None));
    }
}
