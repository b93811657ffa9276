//! Tests end sets that are not convex: finite sets, unions, spheres. The piece or side that is
//! nearest in the Euclidean sense need not be nearest in the metric.

use std::{f64::consts::TAU, sync::Arc};

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_discretizations::Rule;
use tautline_metrics::{
    Metric,
    gallery::{Constant, Lens, Valleys},
};
use tautline_optimizers::{Minimum, Options, Starts, minimise};
use tautline_sets::{ClosedSet, Ends, FiniteSet, Sphere, Union};

use crate::setup::{
    assert_close, ball, between, bump, from_to, lowest, only, point, sequence, straight,
};

#[track_caller]
fn solve<const D: usize>(metric: &impl Metric<D>, ends: &Ends<D>, n: usize) -> Minimum<D> {
    let minimum = lowest(metric, ends, Rule::TRAPEZOIDAL, n);
    assert!(minimum.is_local_minimum(), "{:?} {:?}", minimum.stop, minimum.curvature);
    minimum
}

/// `(3.5, 0)` is nearer in the Euclidean sense, but lies beyond the ridge, with `d = 7 + 0.35`.
/// Along the valley to `(0, 5)` the distance is `d = 5`, exactly on every grid.
#[test]
fn a_point_along_the_valley_beats_a_nearer_one_beyond_the_ridge() {
    let (beyond, along) = ([3.5, 0.0], [0.0, 5.0]);
    for targets in [[beyond, along], [along, beyond]] {
        let set = FiniteSet::new(targets).expect("finite");
        // The claim holds from N = 5 on. With fewer chords a jump over the ridge may be cheaper.
        for n in [9, 40, 300] {
            for ends in
                [between(point([0.0, 0.0]), set.clone()), between(set.clone(), point([0.0; 2]))]
            {
                let minimum = solve(&Valleys, &ends, n);
                assert_close(minimum.energy, 25.0, 1e-14);
                let both = [minimum.sequence.first(), minimum.sequence.last()];
                assert!(both.contains(&&SVector::from(along)));
                let higher = (7.0 - 3.5_f64.sin()).powi(2);
                // E_N − d² = O(N⁻²) with a constant of about 30, which is a twentieth at N = 9.
                assert!(n < 40 || (minimum.local_minima[1] / higher - 1.0).abs() < 0.05);
            }
        }
    }
}

#[test]
fn the_best_pair_of_two_finite_sets_is_found() {
    let first = FiniteSet::new([[0.0, 9.0], [1.0, 0.0], [0.0, 0.0]]).expect("finite");
    let second = FiniteSet::new([[4.0, 0.0], [0.0, 3.5], [-4.0, 1.0]]).expect("finite");
    let minimum = solve(&Valleys, &between(first, second), 100);
    // In the Euclidean sense the nearest points are (1, 0) and (4, 0). They are 3 apart, with d = 6
    // + sin 1 − sin 4 = 7.6.
    assert_eq!(*minimum.sequence.first(), vector![0.0, 0.0]);
    assert_eq!(*minimum.sequence.last(), vector![0.0, 3.5]);
    assert_close(minimum.energy, 3.5 * 3.5, 1e-14);
}

/// The ball behind the bump is nearer in the Euclidean sense, the ball to the side of it in the
/// metric.
#[test]
fn a_ball_beside_the_bump_beats_a_nearer_one_behind_it() {
    let bump = bump();
    let (behind, beside) = (ball([1.2, 0.0], 0.1), ball([-1.5, 2.9], 0.1));
    let start = point([-1.5, 0.0]);
    let alone = [&behind, &beside]
        .map(|ball| solve(&bump, &between(start.clone(), ball.clone()), 200).energy);
    assert!(alone[1] < 0.6 * alone[0], "{alone:?}: (2.8)² against more than 4²");
    for pieces in [[&behind, &beside], [&beside, &behind]] {
        let members: Vec<Arc<dyn ClosedSet<2>>> =
            pieces.map(|piece| Arc::new(piece.clone()) as _).to_vec();
        let union = Union::new(members).expect("two");
        let minimum = solve(&bump, &between(start.clone(), union), 200);
        // It is the same search, so the energies are equal up to the decrement.
        assert_close(minimum.energy, alone[1], 1e-14);
        assert!((beside.project(minimum.sequence.last()) - minimum.sequence.last()).amax() < 1e-15);
    }
}

/// The union is nested, and under the constant metric the second coordinate counts three times. The
/// squared distance is `(3 · 1.5)² = 20.25` to the ball above and `3.5² = 12.25` to the ball on the
/// right.
#[test]
fn the_ball_of_a_nested_union_is_the_nearest_in_the_metric() {
    let metric = Constant::new(matrix![1.0, 0.0; 0.0, 9.0]).expect("definite");
    let ball = |x: f64, y: f64| -> Arc<dyn ClosedSet<2>> { Arc::new(ball([x, y], 0.5)) };
    let inner = Union::new(vec![ball(0.0, 2.0), ball(4.0, 0.0)]).expect("two");
    let union = Union::new(vec![ball(0.0, -3.0), Arc::new(inner)]).expect("two");
    for n in [1, 6, 100, 2000] {
        let minimum = solve(&metric, &between(point([0.0, 0.0]), union.clone()), n);
        assert_close(minimum.energy, 12.25, 1e-14);
        // The three balls give three minima.
        assert_eq!(minimum.local_minima.len(), 3, "{:?}", minimum.local_minima);
        assert_eq!(minimum.others.len(), 2, "{n}");
        for (other, (energy, x2)) in minimum.others.iter().zip([(20.25, 1.5), (56.25, -2.5)]) {
            assert_close(other.energy, energy, 1e-14);
            assert!((other.sequence.last() - vector![0.0, x2]).amax() < 1e-14, "{n}");
            // Beyond 512 chords only the result is followed.
            assert!(other.sequence.n().get() == n || (n > 512 && other.sequence.n().get() <= 512));
        }
    }
}

/// The hill is symmetric about the axis, so there are two minimisers of the same energy.
#[test]
fn a_mirror_image_is_another_minimiser() {
    let ends = between(point([-2.0, 0.0]), point([2.0, 0.0]));
    for n in [16, 100, 2000] {
        let minimum = solve(&bump(), &ends, n);
        let [mirror] = minimum.others.as_slice() else { panic!("{n}: {}", minimum.others.len()) };
        let coarse = mirror.sequence.n().get();
        assert!(coarse <= n);
        for (i, x) in mirror.sequence.points().iter().enumerate() {
            let y = minimum.sequence.points()[(i * n).div_ceil(coarse)];
            // The grids differ, and the points of the coarser one are off by its error.
            assert!((x[1] + y[1]).abs() < 0.1, "{n}, {i}: {x} {y}");
        }
        assert!(mirror.sequence.points().iter().any(|x| x[1].abs() > 0.5));
    }
}

/// Returns the squared distance between `p` and the unit circle, by a scan and a ternary search.
fn circle_distance(h: &SMatrix<f64, 2, 2>, p: &SVector<f64, 2>) -> f64 {
    let square = |t: f64| {
        let d = vector![t.cos(), t.sin()] - p;
        d.dot(&(h * d))
    };
    let scan = 2000;
    let angle = |k: f64| k * TAU / f64::from(scan);
    let best = (0..scan)
        .map(f64::from)
        .min_by(|&a, &b| square(angle(a)).total_cmp(&square(angle(b))))
        .expect("2000 angles");
    let (mut a, mut b) = (angle(best - 1.0), angle(best + 1.0));
    for _ in 0..80 {
        let third = (b - a) / 3.0;
        *(if square(a + third) < square(b - third) { &mut b } else { &mut a }) =
            if square(a + third) < square(b - third) { b - third } else { a + third };
    }
    square(0.5 * (a + b))
}

/// Points lie inside and outside a circle, under oblique metrics with condition numbers up to 20.
/// The nearest point is not the Euclidean one, and there may be two local minima or four.
#[test]
fn the_point_of_a_circle_is_the_nearest_in_the_metric() {
    let mut several = 0;
    for k in 0..120 {
        let t = f64::from(k);
        let turn = nalgebra::Rotation2::new(1.1 * t).into_inner();
        let stretch = 1.0 + 9.5 * (1.0 + (0.37 * t).sin());
        let h = turn * SMatrix::from_diagonal(&vector![1.0, stretch]) * turn.transpose();
        let h = (h + h.transpose()) * 0.5;
        let metric = Constant::new(h).expect("definite");
        let radius = if k % 2 == 0 { 0.05 + 0.9 * (0.61 * t).sin().abs() } else { 1.0 + 0.03 * t };
        let p = vector![(2.1 * t).cos(), (2.1 * t).sin()] * radius;
        let reference = circle_distance(&h, &p);
        let circle = Sphere::new([0.0, 0.0], 1.0).expect("a radius");
        for n in [1, 2, 9, 40] {
            // The circle and the point are tried in either order.
            let first = (k + n as i32) % 3 == 0;
            let p = point(p);
            let minimum = solve(
                &metric,
                &if first { between(circle.clone(), p) } else { between(p, circle.clone()) },
                n,
            );
            // The scan rounds numbers of size 1, with an absolute error of h · 1e-16.
            let error = (minimum.energy - reference).abs();
            assert!(error <= 1e-12 * reference + 1e-14, "{k} {n}: {error:e}");
            let end = if first { minimum.sequence.first() } else { minimum.sequence.last() };
            let off = end.norm() - 1.0;
            assert!(off.abs() <= 4.0 * f64::EPSILON, "{off:e} off the circle");
            several += usize::from(minimum.local_minima.len() > 1);
        }
    }
    assert!(several > 100, "several local minima in {several} cases only");
}

/// The point is inside a sphere, on an axis, with `H = diag(4, 1, 2)`. By Lagrange's condition the
/// nearest points are `x₁ = 4p/(4 − 1)`, `x₂ = ±(1 − x₁²)^{1/2}`; the axis leads to a saddle.
#[test]
fn inside_a_sphere_the_nearest_point_lies_off_the_axis() {
    let metric = Constant::new(SMatrix::from_diagonal(&vector![4.0, 1.0, 2.0])).expect("definite");
    let p = 0.2;
    let x1: f64 = 4.0 * p / 3.0;
    let reference = 4.0 * (x1 - p).powi(2) + 1.0 - x1 * x1;
    let sphere = Sphere::new([0.0; 3], 1.0).expect("a radius");
    let ends = between(point([p, 0.0, 0.0]), sphere);
    for n in [1, 5, 64] {
        let minimum = solve(&metric, &ends, n);
        assert_close(minimum.energy, reference, 1e-13);
        assert!((minimum.sequence.last()[0] - x1).abs() < 1e-7);
        // This search starts from the saddle alone.
        let options = only(straight([p, 0.0, 0.0], [1.0, 0.0, 0.0], n));
        let left = minimise(&metric, &ends, Rule::TRAPEZOIDAL, n, &options).expect("a metric");
        assert!(left.is_local_minimum());
        assert_close(left.energy, reference, 1e-13);
    }
}

/// For a lens and for a bump there is a minimiser on either side, with the same energy.
#[test]
fn two_equal_minimisers_are_mirror_images() {
    let lens = Lens::new(8.0, 0.5).expect("positive");
    let bump = bump();
    check_mirror(&lens);
    check_mirror(&bump);
}

fn check_mirror(metric: &impl Metric<2>) {
    let n = 100;
    let ends = from_to([-1.5, 0.0], [1.5, 0.0]);
    let search = |starts| {
        let options = Options { starts, ..Options::default() };
        let minimum = minimise(metric, &ends, Rule::TRAPEZOIDAL, n, &options).expect("a metric");
        assert!(minimum.is_local_minimum());
        minimum
    };
    let bent = |side: f64| {
        let points = (0..=n).map(|k| {
            let t = k as f64 / n as f64;
            vector![3.0 * t - 1.5, side * 4.0 * t * (1.0 - t)]
        });
        Starts::Only(vec![sequence(points.collect())])
    };
    let (above, below) = (search(bent(1.0)), search(bent(-1.0)));
    assert_close(above.energy, below.energy, 1e-14);
    for (a, b) in above.sequence.points().iter().zip(below.sequence.points()) {
        // A relative decrement below 1e-18 leaves displacements of about 1e-9.
        assert!((a - vector![b[0], -b[1]]).amax() < 1e-8);
    }
    assert!(above.sequence.points()[n / 2][1] > 0.3);
    // From the axis, which is a saddle, and from all automatic starts the search finds the same
    // energy, which is counted once.
    let axis = straight([-1.5, 0.0], [1.5, 0.0], n);
    for minimum in [search(Starts::Only(vec![axis])), search(Starts::Automatic)] {
        assert_close(minimum.energy, above.energy, 1e-14);
        assert_eq!(minimum.local_minima.len(), 1);
    }
}
