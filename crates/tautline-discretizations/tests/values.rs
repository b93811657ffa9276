//! Discrete energies and lengths with values that follow from a line of arithmetic.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use nalgebra::vector;
use tautline_discretizations::{
    BlockTridiagonal, Interpolation, LeftEndpoint, PointSequence, Rule, Trapezoidal, TrueTrapezoid,
};
use tautline_metrics::gallery::{Sphere, Valleys};

/// One chord from `(0, 0)` to `(2π, 0)`: the midpoint sees the ridge `f = 3`, both ends `f = 1`.
#[test]
fn the_rules_read_the_metric_where_they_say() {
    let chord = PointSequence::straight([0.0, 0.0], [TAU, 0.0], 1).expect("finite");
    assert_relative_eq!(
        Trapezoidal.energy(&Valleys, &chord),
        9.0 * TAU * TAU,
        max_relative = 1e-15
    );
    assert_relative_eq!(TrueTrapezoid.energy(&Valleys, &chord), TAU * TAU, max_relative = 1e-15);
    let chord = PointSequence::straight([0.0, 0.0], [PI, 0.0], 1).expect("finite");
    assert_relative_eq!(LeftEndpoint.energy(&Valleys, &chord), PI * PI, max_relative = 1e-15);
    assert_relative_eq!(LeftEndpoint.length(&Valleys, &chord), PI, max_relative = 1e-15);
    let back = PointSequence::straight([PI, 0.0], [0.0, 0.0], 1).expect("finite");
    assert_relative_eq!(LeftEndpoint.energy(&Valleys, &back), 9.0 * PI * PI, max_relative = 1e-15);
}

/// One jump among `N` chords costs `N` times the energy of one chord, but the same length.
#[test]
fn a_jump_costs_energy_but_no_length() {
    for n in [1_usize, 2, 5, 64] {
        let mut points = vec![vector![0.0, 0.0]; n];
        points.push(vector![2.0 * TAU, 0.0]);
        let jump = PointSequence::new(points).expect("finite");
        let energy = 16.0 * PI * PI * n as f64;
        assert_relative_eq!(Trapezoidal.energy(&Valleys, &jump), energy, max_relative = 1e-14);
        assert_relative_eq!(Trapezoidal.length(&Valleys, &jump), 2.0 * TAU, max_relative = 1e-14);
        assert_relative_eq!(LeftEndpoint.length(&Valleys, &jump), 2.0 * TAU, max_relative = 1e-14);
        let speeds = Trapezoidal.speeds(&Valleys, &jump);
        assert!(speeds[..n - 1].iter().all(|&speed| speed == 0.0));
        assert_relative_eq!(speeds[n - 1], 2.0 * TAU * n as f64, max_relative = 1e-14);
    }
}

/// `E ≥ L²` for every rule and for the curve (Cauchy–Schwarz), with equality at equal speeds.
#[test]
fn energy_is_at_least_length_squared() {
    let points =
        vec![vector![-0.5, 0.2], vector![0.1, 0.4], vector![0.11, 0.41], vector![1.4, 0.3]];
    let sequence = PointSequence::new(points).expect("finite");
    let slack = |energy: f64, length: f64| energy / (length * length) - 1.0;
    assert!(
        slack(Trapezoidal.energy(&Sphere, &sequence), Trapezoidal.length(&Sphere, &sequence)) > 0.1
    );
    assert!(
        slack(LeftEndpoint.energy(&Sphere, &sequence), LeftEndpoint.length(&Sphere, &sequence))
            > 0.1
    );
    let curve = Interpolation::new(&sequence);
    assert!(slack(curve.energy(&Sphere).value, curve.length(&Sphere).value) > 0.1);
}

/// Where the metric is NaN the energy is, and nothing panics.
#[test]
fn nan_is_passed_on() {
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
    assert!(Trapezoidal.energy(&Broken, &line).is_nan());
    assert!(Interpolation::new(&line).energy(&Broken).value.is_nan());
}

/// The speed of a chord is the root of the weighted mean, not the mean of the roots: from valley
/// to ridge `f = 1` and `3`, the root of `(1 + 9)/2`.
#[test]
fn speeds_are_roots_of_means() {
    let chord = PointSequence::straight([0.0, 0.0], [PI, 0.0], 1).expect("finite");
    let speed = TrueTrapezoid.speeds(&Valleys, &chord)[0];
    assert_relative_eq!(speed, PI * 5.0_f64.sqrt(), max_relative = 1e-15);
    assert_relative_eq!(TrueTrapezoid.length(&Valleys, &chord), 2.0 * PI, max_relative = 1e-15);
}

#[test]
fn the_zero_matrix_has_its_blocks() {
    let zero = BlockTridiagonal::<2>::zeros(3);
    assert_eq!((zero.diagonal.len(), zero.upper.len()), (4, 3));
    assert!(zero.mul(&[vector![1.0, 2.0]; 4]).iter().all(|block| block.amax() == 0.0));
}
