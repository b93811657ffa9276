//! Leading constants that are explicit.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use nalgebra::matrix;
use tautline_discretizations::{Interpolation, Rule};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Constant, Lens, Ramp, Shear, Valleys},
    quadrature::integrate,
};
use tautline_sets::{Ball, Ends, FiniteSet, HalfSpace, Point, Sphere};

use super::{LeadingConstants, leading_constants};
use crate::{AsymptoticsError, Minimum, Options, extrapolate, minimise};

const N: usize = 4096;

/// `(c/N)²` with `c = 4π`, the length of the longest curve here in units of the scale of its
/// metric.
const SECOND_ORDER: f64 = 1e-5;

fn solve<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
) -> Minimum<D> {
    minimise(metric, ends, rule, n, &Options::default()).expect("a metric")
}

fn constants<const D: usize>(metric: &impl Metric<D>, ends: &Ends<D>) -> LeadingConstants {
    let minimum = solve(metric, ends, Rule::TRAPEZOIDAL, N);
    leading_constants(metric, ends, &minimum).expect("a minimum")
}

fn values(c: &LeadingConstants) -> [f64; 6] {
    [
        c.trapezoidal,
        c.left,
        c.energy_trapezoidal,
        c.length_trapezoidal,
        c.energy_left,
        c.length_left,
    ]
}

/// Compares the constants up to an error of second order relative to the largest of the six,
/// since some sums cancel.
#[track_caller]
fn assert_values(computed: &LeadingConstants, expected: [f64; 6]) {
    let scale = expected.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
    for (computed, expected) in values(computed).into_iter().zip(expected) {
        let error = (computed - expected).abs();
        assert!(error <= SECOND_ORDER * scale, "{computed} is not {expected}");
    }
}

#[test]
fn under_a_constant_metric_there_is_no_error() {
    let metric = Constant::new(matrix![1.0, 0.6; 0.6, 2.0]).expect("definite");
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.3], 3.0).expect("a normal");
    let ends = Ends::new(ball, wall).expect("one bounded");
    assert_eq!(values(&constants(&metric, &ends)), [0.0; 6]);
}

#[test]
fn between_sets_that_touch_there_is_no_error() {
    let ball = Ball::new([0.0, 0.0], 1.0).expect("a radius");
    let ends = Ends::new(ball, Point::new([0.5, 0.0]).expect("finite")).expect("bounded");
    assert_eq!(values(&constants(&Valleys, &ends)), [0.0; 6]);
}

/// With `φ = f²` and `dt = f dx/d`, the geodesic satisfies `γ̈ = −f′ γ̇²/f`. So
/// `∫ γ̈ᵀHγ̈ = d³ ∫ f′²/f³ dx`, `D²H[γ̇, γ̇](γ̇, γ̇) = 2 (f′² + f f″) γ̇⁴` and `w = 2d³ f′/f²`.
/// The curve `γᵖˡ` is the segment.
#[test]
fn in_one_dimension_everything_is_explicit() {
    let ramp = Ramp::new(0.5, 1.0).expect("a ramp");
    let f = |x: f64| 1.0 + 0.5 * x.tanh();
    let first = |x: f64| 0.5 * x.cosh().powi(-2);
    let second = |x: f64| -x.cosh().powi(-2) * x.tanh();
    let (a, b) = (-1.0, 2.0);
    let d = ramp.distance(&[a].into(), &[b].into()).expect("all pairs");
    let bending = d.powi(3) * integrate(|x| first(x).powi(2) / f(x).powi(3), a, b, 1e-13).value;
    let bent = d.powi(3) * integrate(|x| second(x) / f(x).powi(2), a, b, 1e-13).value;
    // −(d²/2) log (φ(γ(1))/φ(γ(0))).
    let left = -0.5 * d * d * (f(b).powi(2) / f(a).powi(2)).ln();
    let energy_left = 13.0 / 12.0 * bending - left * left / (d * d);
    let computed = constants(&ramp, &Ends::points([a], [b]).expect("finite"));
    let expected = [-bent / 12.0, left, bending / 12.0, 0.0, energy_left, 0.0];
    assert_values(&computed, expected);
    // For the reversed curve the error of the left rule changes sign.
    let back = constants(&ramp, &Ends::points([b], [a]).expect("finite"));
    assert_values(&back, [-bent / 12.0, -left, bending / 12.0, 0.0, energy_left, 0.0]);
}

/// For the trapezoidal rule the constants are `−(8π)³ π/9√3` and minus half of it, by
/// `∫₀^{2π} sin² x (2 − cos x)⁻³ dx = π/3√3`. For the left rule the constant is `13` times that
/// half, with `∫ w = 0` by symmetry.
#[test]
fn over_the_valleys_the_constants_are_explicit() {
    let ends = Ends::points([0.0, 0.0], [4.0 * PI, 0.0]).expect("finite");
    let half = (8.0 * PI).powi(3) * PI / (18.0 * 3_f64.sqrt());
    let computed = constants(&Valleys, &ends);
    assert_values(&computed, [-2.0 * half, 0.0, half, 0.0, 13.0 * half, 0.0]);
    // The sums that cancel satisfy a tighter tolerance.
    assert!(computed.left.abs() < 1e-9 && computed.length_trapezoidal.abs() < 1e-9);
}

/// In the flat coordinates `u` the geodesic is `u = (s, 3) t` with `s = 2 + ½ sin 3`, so that
/// `γ̈ = (9/2 sin 3t, 0)` and `w = −9 s sin 3t`. There `E″[ζ, ζ] = 2 ∫ |ζ̇|²` and
/// `F = ½ ∫ u̇₁ sin u₂ u̇₂²`. The minimiser has `ζ̇ = −¾ (3, s) (sin 3t − mean)`.
#[test]
fn on_a_shear_the_constants_are_explicit() {
    let s = 2.0 + 0.5 * 3_f64.sin();
    let d2 = s * s + 9.0;
    let (mean, square) = ((1.0 - 3_f64.cos()) / 3.0, 0.5 - 6_f64.sin() / 12.0);
    let variance = square - mean * mean;
    let bending = 81.0 / 4.0 * square;
    // D²H[v, v](v, v) = 2 |DJ[v] v|² + 2 Jv · D²J[v, v] v, where J v₁ = v₁ + ½ cos(x₂) v₂.
    let wave = 3_f64.sin() / 3.0;
    let second = 2.0 * bending - 27.0 * s * wave;
    let turning = bending * 9.0 / d2;
    let displacement = 9.0 / 16.0 * d2 * variance;
    let shift = 81.0 * s * s * variance / (4.0 * d2);
    let ends = Ends::points([0.0, 0.0], [2.0, 3.0]).expect("finite");
    let computed = constants(&Shear::new(0.5, 1.0).expect("a wave number"), &ends);
    let expected = [
        bending / 12.0 - second / 24.0,
        4.5 * s * mean,
        bending / 12.0,
        turning / 12.0,
        bending / 12.0 + displacement,
        turning / 12.0 + displacement - shift,
    ];
    assert_values(&computed, expected);
}

/// Under `φ I` the error of the left rule depends only on `log φ` at the ends. To first order
/// its curve follows the geodesic, at another speed.
#[test]
fn under_a_conformal_metric_both_rules_have_the_same_length() {
    let (a, b) = ([0.0, 0.0], [2.0, 1.5]);
    let computed = constants(&Valleys, &Ends::points(a, b).expect("finite"));
    assert!(computed.length_trapezoidal > 0.5);
    let tolerance = SECOND_ORDER * computed.energy_left;
    assert!((computed.length_left - computed.length_trapezoidal).abs() <= tolerance);
    let d = Valleys.distance(&a.into(), &b.into()).expect("no turning point");
    let log = 2.0 * (2.0 - 2_f64.cos()).ln();
    assert_relative_eq!(computed.left, -0.5 * d * d * log, max_relative = SECOND_ORDER);
}

/// Both ends of the left rule's curve slide along circles. Extrapolation over grids of 512 and
/// 1024 chords eliminates two terms of the expansion in `1/N`, which leaves an error of up to
/// `(10/N)²`.
#[test]
fn between_curved_sets_the_left_curve_is_as_predicted() {
    let lens = Lens::new(1.0, 1.0).expect("a lens");
    let ball = |x: [f64; 2], r: f64| Ball::new(x, r).expect("a radius");
    let ends = Ends::new(ball([-1.5, 0.4], 0.5), ball([1.5, 0.9], 0.25)).expect("bounded");
    let fine = solve(&lens, &ends, Rule::TRAPEZOIDAL, N);
    let d2 = extrapolate(&fine.levels, 2).expect("five grids").value;
    let scaled = |n: usize| {
        let line = solve(&lens, &ends, Rule::LEFT_ENDPOINT, n).sequence;
        (n * n) as f64 * (Interpolation::new(&line).energy(&lens).value - d2)
    };
    let measured = 2.0 * scaled(1024) - scaled(512);
    let computed = leading_constants(&lens, &ends, &fine).expect("a minimum");
    assert_relative_eq!(computed.energy_left, measured, max_relative = 1e-4);
    // If the ends are fixed, the number is different.
    let line = &fine.sequence;
    let fixed = Ends::points(*line.first(), *line.last()).expect("finite");
    let fixed = leading_constants(&lens, &fixed, &fine).expect("a minimum");
    assert!(fixed.energy_left < 0.99 * computed.energy_left);
}

#[test]
fn only_the_pieces_that_the_curve_joins_count() {
    let (a, b) = ([0.0, 0.0], [2.0, 1.5]);
    let points = Ends::points(a, b).expect("finite");
    let several = |x| FiniteSet::new([[9.0, 9.0], x, [-7.0, 3.0]]).expect("finite");
    let [start, goal] = [a, b].map(|x| Point::new(x).expect("finite"));
    let minimum = solve(&Valleys, &points, Rule::TRAPEZOIDAL, 256);
    let computed = |ends: &Ends<2>| leading_constants(&Valleys, ends, &minimum).expect("a minimum");
    for ends in [
        Ends::new(start, several(b)),
        Ends::new(several(a), goal),
        Ends::new(several(a), several(b)),
    ] {
        let ends = ends.expect("bounded");
        assert_eq!(computed(&ends), computed(&points));
    }
}

#[test]
fn a_minimiser_of_another_problem_is_refused() {
    let ends = Ends::points([0.0, 0.0], [2.0, 1.5]).expect("finite");
    let elsewhere = Ends::points([0.1, 0.0], [2.0, 1.5]).expect("finite");
    let left = solve(&Valleys, &ends, Rule::LEFT_ENDPOINT, 256);
    let right = solve(&Valleys, &ends, Rule::TRAPEZOIDAL, 256);
    for (ends, minimum) in [(&ends, &left), (&elsewhere, &right)] {
        let refused = leading_constants(&Valleys, ends, minimum);
        let Err(AsymptoticsError::NotStationary { decrement }) = refused else {
            panic!("{refused:?}")
        };
        assert!(decrement > 1e-8, "{decrement:e}");
    }
}

#[test]
fn a_minimiser_in_a_continuum_is_refused() {
    let metric = Constant::new(matrix![1.0, 0.0; 0.0, 1.0]).expect("definite");
    let sphere = |r: f64| Sphere::new([0.0, 0.0], r).expect("a radius");
    let ends = Ends::new(sphere(1.0), sphere(2.0)).expect("bounded");
    let minimum = solve(&metric, &ends, Rule::TRAPEZOIDAL, 64);
    let refused = leading_constants(&metric, &ends, &minimum);
    assert_eq!(refused, Err(AsymptoticsError::Degenerate));
}
