//! Degenerate problems: ends that touch, continua of minimisers, sets of size zero, few chords,
//! one dimension. Nothing is NaN, and the result says what it is.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_discretizations::{LeftEndpoint, Rule, Trapezoidal};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Constant, Ramp, Sphere as RoundSphere, Valleys},
};
use tautline_optimizers::{Curvature, Minimum, Options, Stop, extrapolate, minimise};
use tautline_sets::{AxisBox, Ball, ClosedSet, Ends, FiniteSet, HalfSpace, Point, Segment, Sphere};

#[track_caller]
fn solve<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: impl Rule,
    n: usize,
) -> Minimum<D> {
    let minimum = minimise(metric, ends, rule, n, &Options::default()).expect("a metric");
    for value in [minimum.energy, minimum.decrement, minimum.residual, minimum.residual_floor] {
        assert!((0.0..f64::INFINITY).contains(&value), "{minimum:?}");
    }
    assert_eq!(minimum.sequence.n().get(), n);
    minimum
}

#[track_caller]
fn assert_close(value: f64, reference: f64, relative: f64) {
    let error = value / reference - 1.0;
    assert!(error.abs() <= relative, "{value:.15e} is not {reference:.15e}: {error:e}");
}

fn ends<const D: usize>(
    first: impl ClosedSet<D> + 'static,
    second: impl ClosedSet<D> + 'static,
) -> Ends<D> {
    Ends::new(first, second).expect("bounded")
}

fn point<const D: usize>(x: [f64; D]) -> Point<D> {
    Point::new(x).expect("finite")
}

fn half_plane(normal: [f64; 2], offset: f64) -> HalfSpace<2> {
    HalfSpace::at_least(normal, offset).expect("a normal")
}

fn identity<const D: usize>() -> Constant<D> {
    Constant::new(SMatrix::identity()).expect("definite")
}

#[test]
fn sets_that_touch_or_overlap_have_energy_zero() {
    let unit = Ball::new([0.0, 0.0], 1.0).expect("a radius");
    let square = AxisBox::new([2.0, 0.0], [1.0, 1.0]).expect("half-widths");
    let all = [
        // Tangent, also where the contact has coordinates that are rounded; overlapping.
        ends(unit, half_plane([1.0, 0.0], 1.0)),
        ends(unit, half_plane([0.6, 0.8], 1.0)),
        ends(half_plane([1.0, 2.0], 0.3), unit),
        ends(unit, square),
        ends(Sphere::new([0.0, 0.0], 1.0).expect("a radius"), unit),
        // A corner in a corner, a point on a face, a point in itself.
        ends(square, AxisBox::new([4.0, 2.0], [1.0, 1.0]).expect("half-widths")),
        ends(point([2.0, 1.0]), square),
        ends(point([0.3, -0.7]), point([0.3, -0.7])),
        ends(point([0.0, 0.0]), point([0.0, 0.0])),
        ends(point([1e300, 1e300]), point([1e300, 1e300])),
        ends(Segment::new([0.0, -2.0], [0.0, 2.0]).expect("finite"), unit),
    ];
    for ends in &all {
        for n in [1, 2, 7, 100] {
            let minimum = solve(&Valleys, ends, LeftEndpoint, n);
            assert_eq!((minimum.stop, minimum.energy), (Stop::EndsTouch, 0.0), "{ends:?}");
            assert_eq!((minimum.decrement, minimum.residual), (0.0, 0.0));
            assert!(minimum.is_local_minimum());
            let x = *minimum.sequence.first();
            assert!(minimum.sequence.points().iter().all(|y| *y == x));
            for set in [ends.first(), ends.second()] {
                assert!((set.project(&x) - x).amax() <= 6.0 * f64::EPSILON * x.amax());
            }
        }
    }
}

/// Ends a gap apart: `d = gap` for a ball and a half-plane under the identity. A point that is
/// within `(D + 4) ε` of either set counts as common to both.
#[test]
fn sets_that_almost_touch_have_the_energy_of_the_gap() {
    let unit = Ball::new([0.0, 0.0], 1.0).expect("a radius");
    for exponent in 0..=16 {
        let gap = 10_f64.powi(-exponent);
        let minimum =
            solve(&identity(), &ends(unit, half_plane([0.6, 0.8], 1.0 + gap)), Trapezoidal, 10);
        let d = minimum.energy.sqrt();
        assert!((d - gap).abs() <= 12.0 * f64::EPSILON + 1e-9 * gap, "{gap:e}: {d:e}");
        assert_ne!(minimum.stop, Stop::IterationLimit);
        // The force on the ball along its boundary is proportional to the gap.
        if exponent <= 6 {
            assert_eq!(minimum.stop, Stop::Converged);
            assert_eq!(minimum.curvature, Curvature::PositiveDefinite);
        }
    }
}

/// A metric that does not depend on the point, and ends of which one can be moved along with
/// the other: every parallel curve has the same energy, and none is a strict minimum.
#[test]
fn a_continuum_of_minimisers_is_degenerate() {
    let oblique = Constant::new(matrix![2.0, 0.5; 0.5, 1.0]).expect("definite");
    let square = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("half-widths");
    let wide = AxisBox::new([4.0, 0.3], [1.0, 2.0]).expect("half-widths");
    let wall = half_plane([1.0, 0.0], 3.0);
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let shell = Sphere::new([0.0, 0.0], 2.0).expect("a radius");
    // Across: 2² / (nᵀH⁻¹n) = 4 · 1.75 for parallel faces under the oblique metric.
    for n in [1, 2, 3, 7, 64, 500] {
        for (metric, ends, energy) in [
            (oblique, ends(square, wall), 7.0),
            (oblique, ends(wide, square), 7.0),
            (identity(), ends(square, wall), 4.0),
            (identity(), ends(ball, shell), 2.25),
        ] {
            let minimum = solve(&metric, &ends, Trapezoidal, n);
            assert_close(minimum.energy, energy, 1e-14);
            assert_eq!(
                (minimum.stop, minimum.curvature),
                (Stop::Converged, Curvature::Degenerate),
                "{n}, {ends:?}"
            );
            assert!(!minimum.is_local_minimum());
        }
    }
}

/// Antipodes on the round sphere: a continuum of half circles. Discretised the symmetry is
/// lost, but the energy is right.
#[test]
fn antipodes_have_the_energy_of_a_half_circle() {
    let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
    let minimum = solve(&RoundSphere, &ends, Trapezoidal, 512);
    assert_eq!(minimum.stop, Stop::Converged);
    let d2 = extrapolate(&minimum.levels, 2).expect("several grids").value;
    assert_close(d2, std::f64::consts::PI.powi(2), 1e-8);
}

#[test]
fn sets_of_size_zero_are_points() {
    let p = [0.4, 0.2];
    let small: [Ends<2>; 4] = [
        ends(Ball::new(p, 0.0).expect("a radius"), half_plane([1.0, 0.0], 3.0)),
        ends(Sphere::new(p, 0.0).expect("a radius"), half_plane([1.0, 0.0], 3.0)),
        ends(AxisBox::new(p, [0.0, 0.0]).expect("half-widths"), half_plane([1.0, 0.0], 3.0)),
        ends(Segment::new(p, p).expect("finite"), half_plane([1.0, 0.0], 3.0)),
    ];
    for n in [1, 2, 30] {
        let reference =
            solve(&Valleys, &ends(point(p), half_plane([1.0, 0.0], 3.0)), Trapezoidal, n);
        assert!(reference.is_local_minimum());
        for ends in &small {
            let minimum = solve(&Valleys, ends, Trapezoidal, n);
            assert_eq!(minimum.sequence, reference.sequence);
            assert_eq!(minimum.curvature, Curvature::PositiveDefinite);
        }
    }
    // A flat box is a segment.
    let flat = AxisBox::new([0.0, 0.0], [0.0, 2.0]).expect("half-widths");
    let minimum = solve(&Valleys, &ends(flat, point([0.0, 5.0])), Trapezoidal, 40);
    assert_close(minimum.energy, 9.0, 1e-14);
}

/// `N = 1, 2, 3` against formulas and a scan of the one inner point that `N = 2` has.
#[test]
fn very_few_chords_are_minimised_as_they_are() {
    let ends = Ends::points([0.0, 0.0], [2.0, 1.0]).expect("finite");
    let one = solve(&Valleys, &ends, Trapezoidal, 1);
    assert_close(one.energy, 5.0 * (2.0 - 1_f64.cos()).powi(2), 1e-15);
    assert!(one.is_local_minimum(), "there is nothing to vary");
    let two = solve(&Valleys, &ends, Trapezoidal, 2);
    assert!(two.is_local_minimum());
    let energy = |x: SVector<f64, 2>| {
        let cost = |a: SVector<f64, 2>, b: SVector<f64, 2>| {
            (b - a).norm_squared() * (2.0 - (0.5 * (a[0] + b[0])).cos()).powi(2)
        };
        2.0 * (cost(vector![0.0, 0.0], x) + cost(x, vector![2.0, 1.0]))
    };
    assert_close(two.energy, energy(two.sequence.points()[1]), 1e-14);
    let scan = (0..=400).flat_map(|i| (0..=200).map(move |j| (f64::from(i), f64::from(j))));
    for (i, j) in scan {
        let x = vector![i * 0.02 - 3.0, j * 0.02 - 2.0];
        assert!(two.energy <= energy(x) * (1.0 + 1e-14), "less at {x}");
    }
    let three = solve(&Valleys, &ends, Trapezoidal, 3);
    assert!(three.is_local_minimum());
}

#[test]
fn one_dimension_has_sets_too() {
    let ramp = Ramp::new(0.6, 1.5).expect("below one");
    let square = |a: f64, b: f64| {
        ramp.distance(&SVector::from([a]), &SVector::from([b])).expect("all pairs").powi(2)
    };
    let ball = || Ball::new([-1.0], 0.25).expect("a radius");
    let all: [(Ends<1>, f64); 5] = [
        (ends(ball(), HalfSpace::at_least([1.0], 0.5).expect("a normal")), square(-0.75, 0.5)),
        (ends(HalfSpace::new([1.0], -2.0).expect("a normal"), ball()), square(-2.0, -1.25)),
        (ends(AxisBox::new([2.0], [0.5]).expect("a width"), ball()), square(1.5, -0.75)),
        // The sphere is two points. From 0.1 the right one is nearer, but the ramp is dearer.
        (ends(Sphere::new([0.0], 1.0).expect("a radius"), point([0.1])), square(-1.0, 0.1)),
        (ends(point([-3.0]), Segment::new([1.0], [2.0]).expect("finite")), square(-3.0, 1.0)),
    ];
    for (ends, reference) in &all {
        for n in [1, 2, 3, 512] {
            let minimum = solve(&ramp, ends, Trapezoidal, n);
            assert!(minimum.is_local_minimum(), "{ends:?}, {n}");
        }
        let minimum = solve(&ramp, ends, Trapezoidal, 512);
        let d2 = extrapolate(&minimum.levels, 2).expect("several grids").value;
        assert_close(d2, *reference, 1e-9);
    }
}

/// Of several pieces any two may touch: nothing need be searched, on whatever grid.
#[test]
fn pieces_that_touch_are_found_wherever_they_are() {
    let far = [[9.0, 9.0], [-7.0, 3.0]];
    for touching in [[[0.5, 0.0], far[0], far[1]], [far[0], far[1], [0.5, 0.0]]] {
        let several = || FiniteSet::new(touching).expect("finite");
        let ball = || Ball::new([0.0, 0.0], 1.0).expect("a radius");
        for ends in [ends(several(), ball()), ends(ball(), several())] {
            for n in [1, 100] {
                let minimum = solve(&Valleys, &ends, Trapezoidal, n);
                assert_eq!((minimum.stop, minimum.energy), (Stop::EndsTouch, 0.0));
                assert_eq!((minimum.iterations, minimum.levels.len()), (0, 1));
                assert!(minimum.sequence.points().iter().all(|x| *x == vector![0.5, 0.0]));
            }
        }
    }
}
