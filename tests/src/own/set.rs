//! A user's closed set: an ellipse, with distances known in closed form.

use tautline::{
    ClosedSet, Ends, HalfSpace, Metric, Problem, Rule, SMatrix, SVector,
    gallery::{Constant, Shear, Valleys},
};

use super::ellipse::Ellipse;

fn ellipse() -> Ellipse {
    Ellipse::new([0.3, -0.4], [1.2, 0.4], 0.6)
}

/// The nearest point `p` lies in the set, and `x − p` is normal to the set at `p`.
#[test]
fn the_ellipse_of_these_tests_obeys_the_laws_of_a_closed_set() {
    let set = ellipse();
    for x in [[3.0, 0.0], [0.0, 2.0], [-1.5, -1.7], [0.3, 5.0]].map(SVector::from) {
        let p = set.project(&x);
        let (offset, normal) = (x - p, set.form * (p - set.centre));
        // The coordinates have size 5 and the form size 6, and there are some ten roundings each.
        assert!(((p - set.centre).dot(&normal) - 1.0).abs() <= 1e-14);
        let sine = (offset[0] * normal[1] - offset[1] * normal[0]) / offset.norm() / normal.norm();
        assert!(sine.abs() <= 1e-14 && offset.dot(&normal) > 0.0, "{sine:e}");
        let derivative = set.projection_derivative(&x);
        for axis in 0..2 {
            let mut step = SVector::zeros();
            step[axis] = 1e-5;
            let difference = (set.project(&(x + step)) - set.project(&(x - step))) / 2e-5;
            // The error is h²/6 times third derivatives of size 10, plus roundings of size 5 ε/h.
            assert!((difference - derivative.column(axis)).amax() <= 1e-9);
        }
    }
    let inside = SVector::from([0.4, -0.3]);
    assert_eq!(set.project(&inside), inside);
}

/// Solves the problem from the ellipse to the half-plane `{a·x ≥ b}`. The first point must lie on
/// the boundary of the ellipse. Returns the estimate of `d²` and the length.
#[track_caller]
fn arrives<M: Metric<2> + Copy>(metric: M, a: [f64; 2], b: f64, rule: Rule) -> [f64; 2] {
    let set = ellipse();
    let ends = Ends::new(set, HalfSpace::at_least(a, b).expect("a normal")).expect("bounded");
    let line = Problem::new(metric, ends).solve(rule, 256).expect("a metric");
    let z = line.sequence().first() - set.centre;
    // The sizes are 1 and 6, with some ten roundings.
    assert!((z.dot(&(set.form * z)) - 1.0).abs() <= 1e-14, "the first point is not on the ellipse");
    assert!(line.energy().value >= line.discrete_energy().min(line.length().value.powi(2)));
    let estimate = line.distance_squared_estimate().expect("several grids");
    [estimate.value, line.length().value]
}

/// Under a constant metric `d = (b − max a·x) / (aᵀA⁻¹a)^{1/2}`, and the discrete energies have no
/// error at all.
#[test]
fn from_an_ellipse_to_a_half_plane_under_a_constant_metric() {
    let matrix = SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0);
    let a = SVector::from([1.0, 0.7]);
    let inverse = matrix.try_inverse().expect("positive definite");
    let d = (4.0 - ellipse().support(&a)) / a.dot(&(inverse * a)).sqrt();
    let metric = Constant::new(matrix).expect("positive definite");
    for [d2, length] in [
        arrives(metric, [1.0, 0.7], 4.0, Rule::TRAPEZOIDAL),
        arrives(metric, [1.0, 0.7], 4.0, Rule::LEFT_ENDPOINT),
    ] {
        // d is a difference, of size 3, of numbers of size 4; extrapolation doubles the roundings.
        approx::assert_relative_eq!(d2, d * d, max_relative = 1e-13);
        approx::assert_relative_eq!(length, d, max_relative = 1e-13);
    }
}

/// The valleys have the calibration `u = 2x₁ − sin x₁`, so the distance is the increase of `u` from
/// the point of the ellipse farthest to the right.
#[test]
fn from_an_ellipse_to_a_half_plane_over_the_valleys() {
    let climb = |x: f64| 2.0 * x - x.sin();
    let d = climb(4.0) - climb(ellipse().support(&SVector::from([1.0, 0.0])));
    for [d2, length] in [
        arrives(Valleys, [1.0, 0.0], 4.0, Rule::TRAPEZOIDAL),
        // The curve runs along a line to the right, on which f has no symmetry.
        arrives(Valleys, [1.0, 0.0], 4.0, Rule::LEFT_ENDPOINT),
    ] {
        // The estimate extrapolates from 16, 64 and 256. Its error for the left rule is (16 · 64 ·
        // 256)⁻¹ times a constant of size 100, and far smaller for the trapezoidal rule. A line
        // along the axis has no excess length.
        approx::assert_relative_eq!(d2, d * d, max_relative = 1e-4);
        approx::assert_relative_eq!(length, d, max_relative = 1e-12);
    }
}

/// A shear preserves `x₂`, so that the distance is the height of the half-plane above the highest
/// point.
#[test]
fn from_an_ellipse_to_a_half_plane_under_a_shear() {
    let metric = Shear::new(0.5, 1.0).expect("valid");
    let d = 3.0 - ellipse().support(&SVector::from([0.0, 1.0]));
    let [d2, length] = arrives(metric, [0.0, 1.0], 3.0, Rule::TRAPEZOIDAL);
    // The discrete energies attain d², since x₁ is free to follow the wave. The excess of the
    // interpolation is N⁻² times a constant of size 1.
    approx::assert_relative_eq!(d2, d * d, max_relative = 1e-13);
    assert!(length >= d && length <= d + 1.0 / 65536.0, "{length} beside {d}");
}
