//! The discrete geodesic calculus: orders against exact formulas, identities, and every error.

use nalgebra::{SMatrix, SVector, vector};
use tautline::gallery::Valleys;
use tautline::{Metric, PointSequence, Rule, Scalar, SequenceError, SolveError, energy_gradient};
use tautline_baselines::geodesic_calculus::{
    CalculusError, discrete_exponential, discrete_geodesic, discrete_logarithm, extend, midpoint,
    parallel_transport,
};

use crate::problems::{Cut, Exact, Vector, for_each_problem};

/// Returns the errors of each quantity at `N = 32, 64, 128, 256`.
fn errors(error: impl Fn(usize) -> f64) -> [f64; 4] {
    [32, 64, 128, 256].map(error)
}

/// Asserts that errors fall like `N⁻ᑫ`. With the error `c N⁻ᑫ (1 + b/N + …)` the slope between `N`
/// and `2N` differs from `q` by about `|b|/(2N ln 2)`. Where `|b| < 6`, as measured, this is below
/// 0.15 for `N = 32`, and half as much after each doubling.
#[track_caller]
fn assert_order(name: &str, order: f64, errors: [f64; 4]) {
    for (k, pair) in errors.windows(2).enumerate() {
        let slope = (pair[0] / pair[1]).log2();
        let allowed = 0.15 / 2_f64.powi(k as i32);
        assert!((slope - order).abs() < allowed, "{name}: the slope {slope} in {errors:?}");
    }
}

#[test]
fn the_discrete_logarithm_is_of_first_order() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (x.into(), y.into());
        let exact = metric.exact_logarithm(&x, &y);
        let error = |n| discrete_logarithm(metric, &x, &y, n).expect("a geodesic") - exact;
        assert_order(name, 1.0, errors(|n| error(n).norm()));
    }
    for_each_problem!(check);
}

/// The first chord is `v/N` instead of `v/N + a/2N² + …`: an error `O(1/N)` of the velocity. With
/// it the midpoint rule has the order 2, which the next test shows.
#[test]
fn the_discrete_exponential_is_of_first_order() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (x.into(), y.into());
        let v = metric.exact_logarithm(&x, &y);
        let error = |n| discrete_exponential(metric, &x, &v, n).expect("steps").last() - y;
        assert_order(name, 1.0, errors(|n| error(n).norm()));
    }
    for_each_problem!(check);
}

/// The midpoint rule is symmetric, so that the points of a discrete geodesic are of second order;
/// and so is the discrete exponential if its first chord is exact.
#[test]
fn the_points_of_a_discrete_geodesic_are_of_second_order() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let v = metric.exact_logarithm(&x, &y);
        let middle = metric.exact_exponential(&x, &(v * 0.5));
        let error = |n: usize| {
            discrete_geodesic(metric, &x, &y, n).expect("a geodesic").points()[n / 2] - middle
        };
        assert_order(name, 2.0, errors(|n| error(n).norm()));
        // The largest error along the way: at a single point the leading term may vanish.
        let error = |n: usize| {
            let exact = exact_samples(metric, &x, &v, n);
            let (_, chord) = exact.chord(0);
            let path = discrete_exponential(metric, &x, &(chord * n as f64), n).expect("steps");
            let apart = path.points().iter().zip(exact.points()).map(|(a, b)| (a - b).norm());
            apart.fold(0.0, f64::max)
        };
        assert_order(name, 2.0, errors(error));
    }
    for_each_problem!(check);
}

fn exact_samples(metric: &impl Exact, x: &Vector, v: &Vector, n: usize) -> PointSequence<2> {
    let rest = (1..=n).map(|k| metric.exact_exponential(x, &(v * (k as f64 / n as f64))));
    PointSequence::new(std::iter::once(*x).chain(rest).collect()).expect("finite")
}

#[test]
fn parallel_transport_is_of_first_order() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let (v, u) = (metric.exact_logarithm(&x, &y), vector![0.3, 0.7]);
        let exact = metric.exact_transport(&x, &y, &u);
        let error = |n| {
            let path = exact_samples(metric, &x, &v, n);
            parallel_transport(metric, &path, &u).expect("steps") - exact
        };
        assert_order(name, 1.0, errors(|n| error(n).norm()));
        // Along a discrete geodesic, whose points are of second order, it has the same order.
        let error = |n| {
            let path = discrete_geodesic(metric, &x, &y, n).expect("a geodesic");
            parallel_transport(metric, &path, &u).expect("steps") - exact
        };
        assert_order(name, 1.0, errors(|n| error(n).norm()));
    }
    for_each_problem!(check);
}

/// Schild's ladder is for any curve. Under a flat metric transport does not depend on the curve:
/// here along an arc of a circle.
#[test]
fn transport_along_a_curve_that_is_no_geodesic_is_of_first_order() {
    fn check(name: &str, metric: &impl Exact) {
        let at = |t: f64| {
            let (sin, cos) = (2.0 * t).sin_cos();
            vector![0.8 * cos, 0.2 + 0.8 * sin]
        };
        let u = vector![0.3, 0.7];
        let exact = metric.exact_transport(&at(0.0), &at(1.0), &u);
        let error = |n: usize| {
            let points = (0..=n).map(|k| at(k as f64 / n as f64)).collect();
            let path = PointSequence::new(points).expect("finite");
            parallel_transport(metric, &path, &u).expect("steps") - exact
        };
        assert_order(name, 1.0, errors(|n| error(n).norm()));
    }
    check("shear", &crate::problems::shear());
    check("swirl", &crate::problems::swirl());
}

/// Both solve the same equations, from either end. Each of `N` steps rounds by `ε`, and an error of
/// the first chords grows in proportion to `N`: `N² ε`, times the growth of errors along the
/// geodesic, below 10.
#[test]
fn the_discrete_exponential_inverts_the_discrete_logarithm() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (x.into(), y.into());
        for n in [1, 2, 7, 64] {
            let v = discrete_logarithm(metric, &x, &y, n).expect("a geodesic");
            let path = discrete_exponential(metric, &x, &v, n).expect("steps");
            assert_eq!(path.n().get(), n);
            let rounding = 10.0 * (n * n) as f64 * f64::EPSILON;
            let miss = (path.last() - y).norm();
            assert!(miss <= rounding, "{name}, {n}: {miss:e}");
        }
    }
    for_each_problem!(check);
}

/// The equations of the calculus are those of a stationary discrete energy. `N W` has gradients of
/// size 10, and the rounding of a point is `ε`.
#[test]
fn three_points_of_the_calculus_have_a_stationary_energy() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], _: [f64; 2]) {
        let x = Vector::from(x);
        let y = x + vector![0.1, 0.15];
        let z = extend(metric, &x, &y).expect("a point");
        let again = midpoint(metric, &x, &z).expect("a point");
        for points in [vec![x, y, z], vec![x, again, z]] {
            let sequence = PointSequence::new(points).expect("finite");
            let (_, gradient) = energy_gradient(Rule::TRAPEZOIDAL, metric, &sequence);
            assert!(gradient[1].norm() < 1e-13, "{name}: {}", gradient[1]);
            assert!(gradient[0].norm() > 0.1);
        }
        assert!((again - y).norm() < 1e-13, "{name}: {again} for {y}");
    }
    for_each_problem!(check);
}

/// Points that do not move stay where they are.
#[test]
fn a_vector_of_length_zero_leads_nowhere() {
    let x = vector![0.7, -0.3];
    let path = discrete_exponential(&Valleys, &x, &vector![0.0, 0.0], 4).expect("steps");
    assert!(path.points().iter().all(|point| *point == x));
    assert_eq!(midpoint(&Valleys, &x, &x), Ok(x));
    let zero = parallel_transport(&Valleys, &path, &vector![0.0, 0.0]);
    assert_eq!(zero, Ok(vector![0.0, 0.0]));
}

#[test]
fn input_that_is_not_finite_is_an_error() {
    let (x, bad) = (vector![0.0, 0.0], vector![1.0, f64::INFINITY]);
    let error = |what| CalculusError::NotFinite { what, coordinate: 1, value: f64::INFINITY };
    assert_eq!(discrete_logarithm(&Valleys, &bad, &x, 4), Err(error("first point")));
    assert_eq!(discrete_geodesic(&Valleys, &x, &bad, 4), Err(error("second point")));
    assert_eq!(discrete_exponential(&Valleys, &bad, &x, 4), Err(error("point")));
    assert_eq!(discrete_exponential(&Valleys, &x, &bad, 4), Err(error("velocity")));
    assert_eq!(extend(&Valleys, &bad, &x), Err(error("first point")));
    assert_eq!(extend(&Valleys, &x, &bad), Err(error("second point")));
    assert_eq!(midpoint(&Valleys, &bad, &x), Err(error("first point")));
    assert_eq!(midpoint(&Valleys, &x, &bad), Err(error("second point")));
    let path = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 2).expect("finite");
    assert_eq!(parallel_transport(&Valleys, &path, &bad), Err(error("vector")));
}

#[test]
fn no_chords_and_too_many_are_errors() {
    let (x, v) = (vector![0.0, 0.0], vector![1.0, 0.0]);
    let none = SequenceError::NoSubinterval { points: 1 };
    assert_eq!(discrete_exponential(&Valleys, &x, &v, 0), Err(CalculusError::Sequence(none)));
    let many = tautline::LARGEST_N + 1;
    let most = SequenceError::TooManySubintervals { n: many };
    assert_eq!(discrete_exponential(&Valleys, &x, &v, many), Err(CalculusError::Sequence(most)));
    let none = CalculusError::Solve(SolveError::NoSubinterval);
    assert_eq!(discrete_logarithm(&Valleys, &x, &v, 0), Err(none));
}

/// The metric is cut at 0. A geodesic from 1 with the velocity −2 is there before the time 1; with
/// four chords of length ½ the third lies beyond.
#[test]
fn a_step_out_of_the_domain_is_an_error_with_its_number() {
    let steps = |v: f64, n| discrete_exponential(&Cut, &vector![1.0], &vector![v], n);
    match steps(-2.0, 4) {
        Err(CalculusError::LeavesTheDomain { step, .. }) => {
            assert!(step == 1 || step == 2, "{step}")
        }
        other => panic!("{other:?}"),
    }
    let only = steps(-4.0, 1);
    assert!(matches!(only, Err(CalculusError::LeavesTheDomain { step: 0, .. })), "{only:?}");
    assert!(steps(-0.5, 4).is_ok());
    let path = PointSequence::straight([0.5], [-1.0], 3).expect("finite");
    let found = parallel_transport(&Cut, &path, &vector![0.1]);
    assert!(matches!(found, Err(CalculusError::LeavesTheDomain { step: 0 | 1, .. })), "{found:?}");
    let found = midpoint(&Cut, &vector![-1.0], &vector![0.5]);
    assert!(matches!(found, Err(CalculusError::LeavesTheDomain { step: 0, .. })), "{found:?}");
    let found = discrete_logarithm(&Cut, &vector![-1.0], &vector![0.5], 4);
    assert!(matches!(found, Err(CalculusError::Solve(SolveError::Metric(_)))), "{found:?}");
}

/// The line with `H = 1`, and NaN to the left of 0.
struct FlatCut;

impl Metric<1> for FlatCut {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0].sqrt() * 0.0 + 1.0)
    }
}

/// A chord from `x` to `y` carries the point `x + s` to `y + s`, by way of the middle `c = (x + s +
/// y)/2`. The metric is evaluated in the middle of the chords from `x + s` to `c` and from `c` to
/// `y`, and then from `x` to `c` and from `c` to `y + s`.
#[test]
fn an_error_of_a_transport_has_the_number_of_its_chord() {
    let number = |points: &[f64], s: f64| {
        let path = points.iter().map(|&x| vector![x]).collect();
        let path = PointSequence::new(path).expect("finite");
        match parallel_transport(&FlatCut, &path, &vector![s * (points.len() - 1) as f64]) {
            Err(CalculusError::LeavesTheDomain { step, .. }) => Some(step),
            Ok(_) => None,
            other => panic!("{other:?}"),
        }
    };
    // From c = 0.025 to −0.8.
    let path = [2.0, 1.4, 0.8, -0.8];
    // From c = 0.35 to ½ − 1.
    let other = [3.0, 2.0, 1.2, 0.5];
    for begin in 0..3 {
        assert_eq!(number(&path[begin..], 0.05), Some(2 - begin));
        assert_eq!(number(&other[begin..], -1.0), Some(2 - begin));
    }
    assert_eq!((number(&path[..3], 0.05), number(&other[..3], -1.0)), (None, None));
    // From −1 to c = ¾.
    assert_eq!(number(&[4.0, -1.0, 0.5], 2.0), Some(1));
    assert_eq!(number(&[-1.0, 0.5], 2.0), Some(0));
}

/// Where the chords become too long, as is derived below, the ladder ends too.
#[test]
fn a_transport_without_a_solution_has_the_number_of_its_chord() {
    for steps in 0..3 {
        let mut points: Vec<_> = (0..=steps).map(|k| vector![0.1 * k as f64]).collect();
        points.push(points[steps].add_scalar(1.4));
        let path = PointSequence::new(points).expect("finite");
        let found = parallel_transport(&crate::problems::Runaway, &path, &vector![0.1]);
        let Err(CalculusError::NoConvergence { step, .. }) = found else { panic!("{found:?}") };
        assert_eq!(step, steps);
    }
}

/// For `W = e^{−(y+z)} (z − y)²` on the line the equation of a step has no solution if the chord is
/// long: with `s = z − y` and the chord `r` before, it says `e^{−s}(2s + s²) = e^{r}(2r − r²)`,
/// whose left side is at most `e^{−√2}(2√2 + 2) < 1.18`, while for `r = ½` the right side is
/// `1.23…`.
#[test]
fn a_step_without_a_solution_is_an_error() {
    let extended = |r: f64| {
        let (x, y): (SVector<f64, 1>, SVector<f64, 1>) = (vector![0.0], vector![r]);
        extend(&crate::problems::Runaway, &x, &y)
    };
    assert!(extended(0.1).is_ok_and(|z| z[0] > 0.2));
    let found = extended(0.5);
    assert!(matches!(found, Err(CalculusError::NoConvergence { step: 1, .. })), "{found:?}");
}
