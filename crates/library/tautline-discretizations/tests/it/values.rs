//! Compares discrete energies and lengths with values that take a line of arithmetic.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use nalgebra::{SMatrix, vector};
use tautline_discretizations::{
    BlockTridiagonal, Interpolation, LinearModel, PointSequence, QuadraticModel, Rule,
    energy_gradient,
};
use tautline_formula::Plain;
use tautline_metrics::gallery::{Constant, Sphere, Valleys};

/// One chord runs from `(0, 0)` to `(2π, 0)`, with the ridge `f = 3` at its midpoint and `f = 1` at
/// both ends.
#[test]
fn the_rules_evaluate_the_metric_at_their_nodes() {
    let chord = PointSequence::straight([0.0, 0.0], [TAU, 0.0], 1).expect("finite");
    assert_relative_eq!(
        Rule::TRAPEZOIDAL.energy(&Valleys, &chord),
        9.0 * TAU * TAU,
        max_relative = 1e-15
    );
    assert_relative_eq!(
        Rule::TRUE_TRAPEZOID.energy(&Valleys, &chord),
        TAU * TAU,
        max_relative = 1e-15
    );
    let chord = PointSequence::straight([0.0, 0.0], [PI, 0.0], 1).expect("finite");
    assert_relative_eq!(
        Rule::LEFT_ENDPOINT.energy(&Valleys, &chord),
        PI * PI,
        max_relative = 1e-15
    );
    assert_relative_eq!(Rule::LEFT_ENDPOINT.length(&Valleys, &chord), PI, max_relative = 1e-15);
    let back = PointSequence::straight([PI, 0.0], [0.0, 0.0], 1).expect("finite");
    assert_relative_eq!(
        Rule::LEFT_ENDPOINT.energy(&Valleys, &back),
        9.0 * PI * PI,
        max_relative = 1e-15
    );
}

/// One jump in a sequence of `N` chords costs `N` times the energy of one chord, but the same
/// length.
#[test]
fn a_jump_costs_energy_but_no_length() {
    for n in [1_usize, 2, 5, 64] {
        let mut points = vec![vector![0.0, 0.0]; n];
        points.push(vector![2.0 * TAU, 0.0]);
        let jump = PointSequence::new(points).expect("finite");
        let energy = 16.0 * PI * PI * n as f64;
        assert_relative_eq!(
            Rule::TRAPEZOIDAL.energy(&Valleys, &jump),
            energy,
            max_relative = 1e-14
        );
        assert_relative_eq!(
            Rule::TRAPEZOIDAL.length(&Valleys, &jump),
            2.0 * TAU,
            max_relative = 1e-14
        );
        assert_relative_eq!(
            Rule::LEFT_ENDPOINT.length(&Valleys, &jump),
            2.0 * TAU,
            max_relative = 1e-14
        );
        let speeds = Rule::TRAPEZOIDAL.speeds(&Valleys, &jump);
        assert!(speeds[..n - 1].iter().all(|&speed| speed == 0.0));
        assert_relative_eq!(speeds[n - 1], 2.0 * TAU * n as f64, max_relative = 1e-14);
    }
}

/// `E ≥ L²` holds for every rule and for the curve (Cauchy–Schwarz), with equality at equal speeds.
#[test]
fn energy_is_at_least_length_squared() {
    let points =
        vec![vector![-0.5, 0.2], vector![0.1, 0.4], vector![0.11, 0.41], vector![1.4, 0.3]];
    let sequence = PointSequence::new(points).expect("finite");
    let excess = |energy: f64, length: f64| energy / (length * length) - 1.0;
    assert!(
        excess(
            Rule::TRAPEZOIDAL.energy(&Sphere, &sequence),
            Rule::TRAPEZOIDAL.length(&Sphere, &sequence)
        ) > 0.1
    );
    assert!(
        excess(
            Rule::LEFT_ENDPOINT.energy(&Sphere, &sequence),
            Rule::LEFT_ENDPOINT.length(&Sphere, &sequence)
        ) > 0.1
    );
    let curve = Interpolation::new(&sequence);
    assert!(excess(curve.energy(&Sphere).value, curve.length(&Sphere).value) > 0.1);
}

/// A NaN of the metric reaches every result, and nothing panics.
#[test]
fn nan_propagates() {
    struct Broken;
    impl tautline_metrics::Metric<1> for Broken {
        fn gram<S: tautline_metrics::Scalar>(
            &self,
            x: &nalgebra::SVector<S, 1>,
        ) -> nalgebra::SMatrix<S, 1, 1> {
            nalgebra::SMatrix::from_element(x[0].ln())
        }
    }
    let line = PointSequence::straight([1.5], [-1.0], 4).expect("finite");
    assert!(Rule::TRAPEZOIDAL.energy(&Broken, &line).is_nan());
    assert!(Interpolation::new(&line).energy(&Broken).value.is_nan());
    assert!(Interpolation::new(&line).length(&Broken).value.is_nan());
    assert!(Rule::TRAPEZOIDAL.length(&Broken, &line).is_nan());
    assert!(energy_gradient(Rule::TRAPEZOIDAL, &Broken, &line).0.is_nan());
    assert!(QuadraticModel::new(Rule::TRAPEZOIDAL, &Broken, &line).energy.is_nan());
    assert!(Rule::TRAPEZOIDAL.speeds(&Broken, &line).iter().any(|speed| speed.is_nan()));
    // Where `ln x` is negative there is an energy but no length.
    let line = PointSequence::straight([0.25], [0.75], 4).expect("finite");
    assert!(Rule::TRAPEZOIDAL.energy(&Broken, &line) < 0.0);
    assert!(Interpolation::new(&line).energy(&Broken).value < 0.0);
    assert!(Interpolation::new(&line).length(&Broken).value.is_nan());
    assert!(Rule::TRAPEZOIDAL.length(&Broken, &line).is_nan());
}

/// The speed of a chord is the root of the weighted mean, not the mean of the roots. From valley to
/// ridge, with `f = 1` and `3`, it is the root of `(1 + 9)/2`.
#[test]
fn speeds_are_roots_of_means() {
    let chord = PointSequence::straight([0.0, 0.0], [PI, 0.0], 1).expect("finite");
    let speed = Rule::TRUE_TRAPEZOID.speeds(&Valleys, &chord)[0];
    assert_relative_eq!(speed, PI * 5.0_f64.sqrt(), max_relative = 1e-15);
    assert_relative_eq!(
        Rule::TRUE_TRAPEZOID.length(&Valleys, &chord),
        2.0 * PI,
        max_relative = 1e-15
    );
}

#[test]
fn the_zero_matrix_has_its_blocks() {
    let zero = BlockTridiagonal::<2>::zeros(3);
    assert_eq!((zero.diagonal.len(), zero.upper.len()), (4, 3));
    assert!(zero.mul(&[vector![1.0, 2.0]; 4]).iter().all(|block| block.amax() == 0.0));
}

/// One chord of length 1 is followed by 1023 chords that each add less than half an ulp of 1. A
/// plain sum would lose all of them, which are `6e-14` of the result.
#[test]
fn the_contributions_of_many_small_chords_are_not_lost() {
    let identity = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    let chords = 1024;
    // The small chords run along another axis, so that their length is exactly `small`.
    let sequence = |small: f64| {
        let after = (0..chords).map(|k| vector![1.0, f64::from(k) * small]);
        PointSequence::new([vector![0.0, 0.0]].into_iter().chain(after).collect()).expect("finite")
    };
    let little = 2.0_f64.powi(-54);
    let sum = 1.0 + f64::from(chords - 1) * little;
    // The allowance covers the rounding of the result and of its product with N.
    let rounded = |found: f64, exact: f64| {
        assert_relative_eq!(found, exact, max_relative = 4.0 * f64::EPSILON);
    };
    // The small terms of the energy are squares of 2⁻²⁷; those of the length are 2⁻⁵⁴ itself.
    let (squares, lengths) = (sequence(2.0_f64.powi(-27)), sequence(little));
    let n = f64::from(chords);
    rounded(Rule::TRAPEZOIDAL.energy(&identity, &squares), n * sum);
    rounded(Rule::LEFT_ENDPOINT.energy(&identity, &squares), n * sum);
    rounded(Rule::TRUE_TRAPEZOID.energy(&identity, &squares), n * sum);
    rounded(energy_gradient(Rule::TRAPEZOIDAL, &identity, &squares).0, n * sum);
    rounded(QuadraticModel::new(Rule::TRAPEZOIDAL, &identity, &squares).energy, n * sum);
    rounded(Rule::TRAPEZOIDAL.length(&identity, &lengths), sum);
    rounded(Rule::TRUE_TRAPEZOID.length(&identity, &lengths), sum);
    rounded(squares.k3().powi(2), n * sum);
    // The quadrature with seven nodes rounds the long chord a little more.
    let curve = Interpolation::new(&squares).energy(&identity);
    assert_relative_eq!(curve.value, n * sum, max_relative = 16.0 * f64::EPSILON);
    let curve = Interpolation::new(&lengths).length(&identity);
    assert_relative_eq!(curve.value, sum, max_relative = 16.0 * f64::EPSILON);
}

/// The errors of the chords add up, in the unit of the result. The error of each chord is at least
/// two roundings of its contribution.
#[test]
fn the_error_of_a_curve_is_the_sum_of_the_errors_of_its_chords() {
    let identity = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    for n in [1, 2, 7, 64] {
        let line = PointSequence::straight([0.0, 0.0], [3.0, 4.0], n).expect("finite");
        let curve = Interpolation::new(&line);
        for (integral, exact) in [(curve.energy(&identity), 25.0), (curve.length(&identity), 5.0)] {
            assert_relative_eq!(integral.value, exact, max_relative = 16.0 * f64::EPSILON);
            let relative = integral.error / exact;
            assert!((1.5 * f64::EPSILON..1e-13).contains(&relative), "N = {n}: {relative:e}");
        }
    }
}

/// On a straight line the discrete energy converges to the energy of the line with the declared
/// order.
#[test]
fn the_exponent_of_the_error_is_the_observed_order() {
    fn order(rule: Rule) -> f64 {
        let line = |n| PointSequence::straight([0.2, 0.0], [1.4, 0.3], n).expect("finite");
        let limit = Interpolation::new(&line(64)).energy(&Valleys).value;
        let error = |n| rule.energy(&Valleys, &line(n)) - limit;
        (error(256) / error(512)).log2()
    }
    // The next order contributes a relative 1/256, which is less than 0.05 in the logarithm.
    assert!(
        (order(Rule::TRAPEZOIDAL) - f64::from(Rule::TRAPEZOIDAL.error_exponent())).abs() < 0.05
    );
    assert!(
        (order(Rule::TRUE_TRAPEZOID) - f64::from(Rule::TRUE_TRAPEZOID.error_exponent())).abs()
            < 0.05
    );
    assert!(
        (order(Rule::LEFT_ENDPOINT) - f64::from(Rule::LEFT_ENDPOINT.error_exponent())).abs() < 0.05
    );
}

/// Nothing remains from an earlier, finer grid.
#[test]
fn a_model_in_used_memory_equals_a_new_one() {
    let line = |n| PointSequence::straight([-0.5, 0.2], [1.4, 0.3], n).expect("finite");
    let mut used = QuadraticModel::default();
    for n in [9, 4, 4, 1, 6] {
        used.expand_by_batches(Rule::TRUE_TRAPEZOID.nodes(), &Plain::<_, 2>::new(Sphere), &line(n));
        assert_eq!(used, QuadraticModel::new(Rule::TRUE_TRAPEZOID, &Sphere, &line(n)), "N = {n}");
        assert_eq!((used.slopes.len(), used.upper.len()), (2 * (n + 1), 4 * n));
    }
}

/// `diag(2, 6)` has the mean eigenvalue 4, for any number of chords.
#[test]
fn the_size_of_a_metric_is_the_mean_of_its_eigenvalues() {
    let metric = Constant::new(SMatrix::from_diagonal(&vector![2.0, 6.0])).expect("positive");
    for n in [1, 2, 5] {
        let line = PointSequence::straight([0.0, 0.0], [3.0, 4.0], n).expect("finite");
        for mean in [
            QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &line).mean_gram,
            QuadraticModel::new(Rule::TRUE_TRAPEZOID, &metric, &line).mean_gram,
        ] {
            assert_relative_eq!(mean, 4.0, max_relative = 1e-15);
        }
    }
    // From valley to ridge, f² is 1 and 9 at the ends of the chord, and both count.
    let chord = PointSequence::straight([0.0, 0.0], [PI, 0.0], 1).expect("finite");
    let mean = QuadraticModel::new(Rule::TRUE_TRAPEZOID, &Valleys, &chord).mean_gram;
    assert_relative_eq!(mean, 5.0, max_relative = 1e-15);
    let two = PointSequence::new(vec![vector![PI, 0.0], vector![0.0, 0.0], vector![0.0, 1.0]]);
    let mean = QuadraticModel::new(Rule::LEFT_ENDPOINT, &Valleys, &two.expect("finite")).mean_gram;
    assert_relative_eq!(mean, 5.0, max_relative = 1e-15);
}

/// The curve at time 1 is the last point, and the curve at a time in between lies on the chord.
#[test]
fn a_curve_of_one_chord_has_both_ends() {
    let chord = PointSequence::new(vec![vector![2.0, 1.0], vector![4.0, -3.0]]).expect("finite");
    let curve = Interpolation::new(&chord);
    assert_eq!([curve.at(0.0), curve.at(1.0)], [vector![2.0, 1.0], vector![4.0, -3.0]]);
    assert_eq!(curve.at(0.25), vector![2.5, 0.0]);
    assert!(LinearModel::new(Rule::TRAPEZOIDAL, &Sphere, &chord).is_metric);
}
