//! Tests degenerate problems: ends that touch, continua of minimisers, sets of size zero, few
//! chords, and one dimension. Nothing is NaN, and the result reports what it is.

use nalgebra::{SVector, matrix, vector};
use tautline_discretizations::Rule;
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Constant, Ramp, Sphere as RoundSphere, Valleys},
};
use tautline_optimizers::{Curvature, Minimum, Stop};
use tautline_sets::{AxisBox, Ends, FiniteSet, HalfSpace, Segment, Sphere};

use crate::setup::{
    assert_close, ball, between, euclidean, extrapolated, from_to, half_space, lowest, point,
};

#[track_caller]
fn solve<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
) -> Minimum<D> {
    let minimum = lowest(metric, ends, rule, n);
    for value in [minimum.energy, minimum.decrement, minimum.residual, minimum.residual_floor] {
        assert!((0.0..f64::INFINITY).contains(&value), "{minimum:?}");
    }
    assert_eq!(minimum.sequence.n().get(), n);
    minimum
}

#[test]
fn sets_that_touch_or_overlap_have_energy_zero() {
    let unit = ball([0.0, 0.0], 1.0);
    let square = AxisBox::new([2.0, 0.0], [1.0, 1.0]).expect("half-widths");
    let all = [
        // These sets are tangent, also at a contact with rounded coordinates, or they overlap.
        between(unit.clone(), half_space([1.0, 0.0], 1.0)),
        between(unit.clone(), half_space([0.6, 0.8], 1.0)),
        between(half_space([1.0, 2.0], 0.3), unit.clone()),
        between(unit.clone(), square.clone()),
        between(Sphere::new([0.0, 0.0], 1.0).expect("a radius"), unit.clone()),
        // A corner touches a corner, a point lies on a face, and a point coincides with a point.
        between(square.clone(), AxisBox::new([4.0, 2.0], [1.0, 1.0]).expect("half-widths")),
        between(point([2.0, 1.0]), square),
        between(point([0.3, -0.7]), point([0.3, -0.7])),
        between(point([0.0, 0.0]), point([0.0, 0.0])),
        between(point([1e300, 1e300]), point([1e300, 1e300])),
        between(Segment::new([0.0, -2.0], [0.0, 2.0]).expect("finite"), unit),
    ];
    for ends in &all {
        for n in [1, 2, 7, 100] {
            let minimum = solve(&Valleys, ends, Rule::LEFT_ENDPOINT, n);
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

/// For a ball and a half-plane under the identity, `d = gap`. A point within `(D + 4) ε` of either
/// set counts as common to both.
#[test]
fn sets_that_almost_touch_have_the_energy_of_the_gap() {
    let unit = ball([0.0, 0.0], 1.0);
    for exponent in 0..=16 {
        let gap = 10_f64.powi(-exponent);
        let minimum = solve(
            &euclidean(),
            &between(unit.clone(), half_space([0.6, 0.8], 1.0 + gap)),
            Rule::TRAPEZOIDAL,
            10,
        );
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

/// The metric is constant and the ends can be moved together. Every parallel curve has the same
/// energy, and none is a strict minimum.
#[test]
fn a_continuum_of_minimisers_is_degenerate() {
    let oblique = Constant::new(matrix![2.0, 0.5; 0.5, 1.0]).expect("definite");
    let square = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("half-widths");
    let wide = AxisBox::new([4.0, 0.3], [1.0, 2.0]).expect("half-widths");
    let wall = half_space([1.0, 0.0], 3.0);
    let ball = ball([0.0, 0.0], 0.5);
    let shell = Sphere::new([0.0, 0.0], 2.0).expect("a radius");
    // The energy across the gap is 2² / (nᵀH⁻¹n) = 4 · 1.75 for parallel faces under the oblique
    // metric.
    for n in [1, 2, 3, 7, 64, 500] {
        for (metric, ends, energy) in [
            (oblique, between(square.clone(), wall.clone()), 7.0),
            (oblique, between(wide.clone(), square.clone()), 7.0),
            (euclidean(), between(square.clone(), wall.clone()), 4.0),
            (euclidean(), between(ball.clone(), shell.clone()), 2.25),
        ] {
            let minimum = solve(&metric, &ends, Rule::TRAPEZOIDAL, n);
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

/// Antipodes on the round sphere are joined by a continuum of half circles. The discretisation
/// breaks the symmetry, but the energy is still that of a half circle.
#[test]
fn antipodes_have_the_energy_of_a_half_circle() {
    let ends = from_to([-1.0, 0.0], [1.0, 0.0]);
    let minimum = solve(&RoundSphere, &ends, Rule::TRAPEZOIDAL, 512);
    assert_eq!(minimum.stop, Stop::Converged);
    let d2 = extrapolated(&minimum);
    assert_close(d2, std::f64::consts::PI.powi(2), 1e-8);
}

#[test]
fn sets_of_size_zero_are_points() {
    let p = [0.4, 0.2];
    let small: [Ends<2>; 4] = [
        between(ball(p, 0.0), half_space([1.0, 0.0], 3.0)),
        between(Sphere::new(p, 0.0).expect("a radius"), half_space([1.0, 0.0], 3.0)),
        between(AxisBox::new(p, [0.0, 0.0]).expect("half-widths"), half_space([1.0, 0.0], 3.0)),
        between(Segment::new(p, p).expect("finite"), half_space([1.0, 0.0], 3.0)),
    ];
    for n in [1, 2, 30] {
        let reference =
            solve(&Valleys, &between(point(p), half_space([1.0, 0.0], 3.0)), Rule::TRAPEZOIDAL, n);
        assert!(reference.is_local_minimum());
        for ends in &small {
            let minimum = solve(&Valleys, ends, Rule::TRAPEZOIDAL, n);
            assert_eq!(minimum.sequence, reference.sequence);
            assert_eq!(minimum.curvature, Curvature::PositiveDefinite);
        }
    }
    // A flat box is the same as a segment.
    let flat = AxisBox::new([0.0, 0.0], [0.0, 2.0]).expect("half-widths");
    let minimum = solve(&Valleys, &between(flat, point([0.0, 5.0])), Rule::TRAPEZOIDAL, 40);
    assert_close(minimum.energy, 9.0, 1e-14);
}

/// Compares `N = 1, 2, 3` with formulas and, for `N = 2`, with a scan of the only inner point.
#[test]
fn very_few_chords_are_minimised_exactly() {
    let ends = from_to([0.0, 0.0], [2.0, 1.0]);
    let one = solve(&Valleys, &ends, Rule::TRAPEZOIDAL, 1);
    assert_close(one.energy, 5.0 * (2.0 - 1_f64.cos()).powi(2), 1e-15);
    assert!(one.is_local_minimum(), "nothing can vary");
    let two = solve(&Valleys, &ends, Rule::TRAPEZOIDAL, 2);
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
        assert!(two.energy <= energy(x) * (1.0 + 1e-14), "lower at {x}");
    }
    let three = solve(&Valleys, &ends, Rule::TRAPEZOIDAL, 3);
    assert!(three.is_local_minimum());
}

#[test]
fn one_dimension_has_sets_too() {
    let ramp = Ramp::new(0.6, 1.5).expect("below one");
    let square = |a: f64, b: f64| {
        ramp.distance(&SVector::from([a]), &SVector::from([b])).expect("all pairs").powi(2)
    };
    let ball = || ball([-1.0], 0.25);
    let all: [(Ends<1>, f64); 5] = [
        (between(ball(), half_space([1.0], 0.5)), square(-0.75, 0.5)),
        (between(HalfSpace::new([1.0], -2.0).expect("a normal"), ball()), square(-2.0, -1.25)),
        (between(AxisBox::new([2.0], [0.5]).expect("a width"), ball()), square(1.5, -0.75)),
        // The sphere consists of two points. The right one is nearer to 0.1, but lies up the ramp.
        (between(Sphere::new([0.0], 1.0).expect("a radius"), point([0.1])), square(-1.0, 0.1)),
        (between(point([-3.0]), Segment::new([1.0], [2.0]).expect("finite")), square(-3.0, 1.0)),
    ];
    for (ends, reference) in &all {
        for n in [1, 2, 3, 512] {
            let minimum = solve(&ramp, ends, Rule::TRAPEZOIDAL, n);
            assert!(minimum.is_local_minimum(), "{ends:?}, {n}");
        }
        let minimum = solve(&ramp, ends, Rule::TRAPEZOIDAL, 512);
        let d2 = extrapolated(&minimum);
        assert_close(d2, *reference, 1e-9);
    }
}

/// If any two pieces touch, no search is needed, on any grid.
#[test]
fn pieces_that_touch_are_found_in_any_order() {
    let far = [[9.0, 9.0], [-7.0, 3.0]];
    for touching in [[[0.5, 0.0], far[0], far[1]], [far[0], far[1], [0.5, 0.0]]] {
        let several = || FiniteSet::new(touching).expect("finite");
        let ball = || ball([0.0, 0.0], 1.0);
        for ends in [between(several(), ball()), between(ball(), several())] {
            for n in [1, 100] {
                let minimum = solve(&Valleys, &ends, Rule::TRAPEZOIDAL, n);
                assert_eq!((minimum.stop, minimum.energy), (Stop::EndsTouch, 0.0));
                assert_eq!((minimum.iterations, minimum.levels.len()), (0, 1));
                assert!(minimum.sequence.points().iter().all(|x| *x == vector![0.5, 0.0]));
            }
        }
    }
}
