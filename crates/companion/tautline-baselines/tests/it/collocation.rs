//! Collocation: known distances, agreement with shooting, a geodesic that is not minimal, errors.

use nalgebra::{SMatrix, vector};
use tautline::gallery::{Bump, Separable, SpherePatch, Valleys};
use tautline::{
    AffineSubspace, Ball, ClosedSet, Ends, HalfSpace, KnownDistance, Metric, Point, PointSequence,
    Problem, Rule, SetError, Sphere,
};
use tautline_baselines::collocation::{Collocated, Collocation, CollocationError, collocate};
use tautline_baselines::shooting::{Shooting, shoot};

use crate::problems::{Cut, Exact, Vector, for_each_problem};

const ENDS: [[f64; 2]; 2] = [[-1.5, 0.05], [1.5, -0.1]];

/// The energy of the minimal geodesic around the bump, to the digits given.
const AROUND: f64 = 21.858160535;

fn bump() -> Bump {
    Bump::new(4.0, 0.5).expect("a width")
}

fn points<const D: usize>(x: [f64; D], y: [f64; D]) -> Ends<D> {
    Ends::points(x, y).expect("finite")
}

fn over_the_bump(options: &Collocation<2>) -> Result<Collocated<2>, CollocationError> {
    collocate(&bump(), &points(ENDS[0], ENDS[1]), options)
}

/// The tolerance of the residual is `10⁻⁶`, and the energy is stationary: its relative error is of
/// the size of `10⁻¹²`, times a factor that is the larger the more the metric bends.
#[test]
fn collocation_reaches_the_known_distance() {
    #[track_caller]
    fn check<const D: usize>(metric: &impl KnownDistance<D>, x: [f64; D], y: [f64; D]) {
        let d = metric.distance(&x.into(), &y.into()).expect("known");
        let found = collocate(metric, &points(x, y), &Collocation::default()).expect("a path");
        assert!((found.length / d - 1.0).abs() < 1e-9, "{} for {d}", found.length);
        assert!((found.energy / (d * d) - 1.0).abs() < 1e-9, "{} for {d}", found.energy);
        assert!(found.residual <= 1e-6 && found.iterations > 0);
    }
    fn exact(_: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        check(metric, x, y);
    }
    for_each_problem!(exact);
    let separable = Separable::new([0.3, 0.5, -0.2], [1.0, 2.0, 1.5]).expect("amplitudes");
    check(&separable, [0.0, 0.0, 0.5], [2.0, 1.0, -1.0]);
    check(&SpherePatch::new(1.0).expect("a radius"), [0.6, -0.2], [-0.3, 0.7]);
    check(&Valleys, [0.5, 0.0], [2.5, 1.0]);
    check(&Valleys, [0.5], [5.5]);
}

/// A residual of at most `10⁻⁸` displaces the curve by at most about `10⁻⁸`, and its velocity by a
/// few times as much.
#[test]
fn the_path_is_the_exact_geodesic_all_along() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let options = Collocation { tolerance: 1e-8, ..Collocation::default() };
        let found = collocate(metric, &points(x, y), &options).expect("a path");
        let (x, y) = (Vector::from(x), Vector::from(y));
        assert_eq!((found.path.position(0.0), found.path.position(1.0)), (Some(x), Some(y)));
        let v = metric.exact_logarithm(&x, &y);
        for k in 1..=40 {
            let t = f64::from(k) / 40.0;
            let exact = metric.exact_exponential(&x, &(v * t));
            let at = found.path.position(t).expect("a time");
            assert!((at - exact).norm() < 1e-8, "{name}: {at} for {exact} at {t}");
            let exact = metric.exact_transport(&x, &exact, &v);
            let velocity = found.path.velocity(t).expect("a time");
            assert!((velocity - exact).norm() < 1e-7, "{name}: {velocity} for {exact} at {t}");
        }
        assert_eq!(found.path.position(1.5), None);
        assert_eq!(found.path.velocity(f64::NAN), None);
    }
    for_each_problem!(check);
}

/// Each is within `10⁻⁹` of the distance, as is tested for both; hence they differ by `2 · 10⁻⁹`.
#[test]
fn collocation_and_shooting_agree() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let ends = points(x, y);
        let path = collocate(metric, &ends, &Collocation::default()).expect("a path");
        let shot = shoot(metric, &ends, &Shooting::default()).expect("a shot").geodesic;
        assert!((path.length / shot.length() - 1.0).abs() < 2e-9, "{name}");
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            let [a, b] = [path.path.position(t), shot.position(t)].map(|at| at.expect("a time"));
            // The residual is 10⁻⁶, which displaces the curve by at most about as much.
            assert!((a - b).norm() < 1e-6, "{name}: {a} and {b} at {t}");
        }
    }
    for_each_problem!(check);
    // Neither is minimal here; they are the same geodesic all the same.
    let ends = points(ENDS[0], ENDS[1]);
    let shot = shoot(&bump(), &ends, &Shooting::default()).expect("a shot").geodesic;
    let path = over_the_bump(&Collocation::default()).expect("a path");
    assert!((path.length / shot.length() - 1.0).abs() < 2e-9);
}

/// A geodesic that comes back to where it begins, around the bump: its size is not the distance of its ends.
/// It is its own mirror image, run backwards.
#[test]
fn a_geodesic_may_end_where_it_begins() {
    let (begin, n) = ([1.5, 0.0], 16);
    let at = |k: usize| {
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
        if k == 0 || k == n { begin.into() } else { vector![0.25 + 1.25 * cos, 1.1 * sin] }
    };
    let start = PointSequence::new((0..=n).map(at).collect()).expect("finite");
    let options = Collocation { start: Some(start), ..Collocation::default() };
    let found = collocate(&bump(), &points(begin, begin), &options).expect("a path");
    assert!(found.residual <= 1e-6);
    let position = |t: f64| found.path.position(t).expect("a time");
    for k in 0..=20 {
        let t = f64::from(k) / 40.0;
        let (there, back) = (position(t), position(1.0 - t));
        // A residual of 10⁻⁶ displaces the curve by about as much.
        assert!((there - vector![back[0], -back[1]]).norm() < 1e-5, "{t}: {there} {back}");
    }
    // Beyond the bump, on its other side.
    assert!(position(0.5)[0] < -0.3, "{}", position(0.5));
}

/// The straight line leads to a geodesic over the bump with almost three times the energy of the
/// minimal one, and nothing in the result says so. Both energies are given to half a unit of their
/// last digit.
#[test]
fn collocation_from_the_straight_line_finds_a_geodesic_that_is_not_minimal() {
    let over = over_the_bump(&Collocation::default()).expect("a path");
    assert!((over.energy - 64.0750).abs() < 5e-5, "{}", over.energy);
    assert!(over.residual <= 1e-6);
    let around = [ENDS[0], [-0.7, -1.0], [0.0, -1.0], [0.7, -1.0], ENDS[1]];
    let around = PointSequence::new(around.map(Into::into).to_vec()).expect("finite");
    let options = Collocation { start: Some(around), ..Collocation::default() };
    let minimal = over_the_bump(&options).expect("a path");
    assert!((minimal.energy - AROUND).abs() < 5e-10, "{}", minimal.energy);
    assert!(over.energy > 2.9 * minimal.energy);
}

#[test]
fn intervals_are_divided_where_the_residual_is_large() {
    let path = over_the_bump(&Collocation::default()).expect("a path").path;
    let mesh = path.mesh();
    assert_eq!((mesh[0], mesh[path.intervals()]), (0.0, 1.0));
    let steps: Vec<f64> = mesh.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let [least, most] =
        [f64::min, f64::max].map(|pick| steps.iter().copied().reduce(pick).expect("some"));
    // The first mesh has steps of 1/16, which are divided by at least 2 each time.
    assert!(least > 0.0 && most <= 1.0 / 16.0 && least < 0.3 * most, "{least} to {most}");
}

#[test]
fn a_path_from_a_point_to_itself_has_no_length() {
    let ends = points([1.0, 2.0], [1.0, 2.0]);
    let found = collocate(&Valleys, &ends, &Collocation::default()).expect("a path");
    assert_eq!((found.energy, found.length, found.residual), (0.0, 0.0, 0.0));
}

/// The distances are those of the test of shots between sets.
#[test]
fn paths_between_sets_reach_the_known_distance() {
    #[track_caller]
    fn check(metric: &impl Metric<2>, ends: Result<Ends<2>, SetError>, d: f64) {
        let ends = ends.expect("valid");
        let found = collocate(metric, &ends, &Collocation::default()).expect("a path");
        assert!((found.length / d - 1.0).abs() < 1e-9, "{} for {d}", found.length);
        let [first, last] = [0.0, 1.0].map(|t| found.path.position(t).expect("a time"));
        assert!((ends.first().project(&first) - first).norm() < 1e-14);
        assert!((ends.second().project(&last) - last).norm() < 1e-14);
    }
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::new([-1.0, 0.0], -3.0).expect("a normal");
    let d = 5.0 - 3_f64.sin() + 0.5_f64.sin();
    check(&Valleys, Ends::new(ball.clone(), wall.clone()), d);
    check(&Valleys, Ends::new(wall, ball), d);
    let circle = |radius| Sphere::new([0.0, 0.0], radius).expect("a radius");
    check(&crate::problems::swirl(), Ends::new(circle(0.5), circle(2.0)), 1.5);
    let line = AffineSubspace::new([0.0, 2.0], [[1.0, 0.0]]).expect("a direction");
    let point = Point::new([0.3, -0.4]).expect("finite");
    check(&crate::problems::shear(), Ends::new(point.clone(), line.clone()), 2.4);
    check(&crate::problems::shear(), Ends::new(line, point), 2.4);
}

/// A set whose nearest-point map is NaN but for the points where the pair of ends looks.
#[derive(Debug)]
struct Hole;

impl ClosedSet<2> for Hole {
    fn project(&self, x: &Vector) -> Vector {
        let seen = x.norm() == 0.0 || x.norm() == 1.0;
        if seen { vector![5.0, 5.0] } else { vector![f64::NAN, f64::NAN] }
    }
    fn projection_derivative(&self, _: &Vector) -> SMatrix<f64, 2, 2> {
        SMatrix::zeros()
    }
    fn radius(&self) -> Option<f64> {
        None
    }
}

#[test]
fn input_of_no_use_is_an_error() {
    let options = Collocation::default();
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let found = collocate(&Valleys, &Ends::new(Hole, ball).expect("no hole"), &options);
    assert!(
        matches!(
            found,
            Err(CollocationError::NotFinite { what: "first point", coordinate: 0, .. })
        ),
        "{found:?}"
    );
    for tolerance in [0.0, -1.0, f64::NAN, 1e-11, 1.0] {
        let found = over_the_bump(&Collocation { tolerance, ..options.clone() });
        assert!(matches!(found, Err(CollocationError::Tolerance { .. })), "{found:?}");
    }
    let none = over_the_bump(&Collocation { intervals: 0, ..options });
    assert_eq!(none, Err(CollocationError::NoIntervals));
}

#[test]
fn a_start_outside_of_the_domain_is_an_error() {
    let found = collocate(&Cut, &points([-1.0], [1.0]), &Collocation::default());
    assert!(matches!(found, Err(CollocationError::LeavesTheDomain(_))), "{found:?}");
}

#[test]
fn too_many_intervals_are_an_error_with_the_residual() {
    match over_the_bump(&Collocation { most_intervals: 20, ..Collocation::default() }) {
        Err(CollocationError::TooManyIntervals { intervals: 16, residual }) => {
            assert!(residual > 1e-6 && residual.is_finite(), "{residual}");
        }
        other => panic!("{other:?}"),
    }
    let found =
        over_the_bump(&Collocation { intervals: 21, most_intervals: 20, ..Collocation::default() });
    let refused = CollocationError::TooManyIntervals { intervals: 21, residual: f64::INFINITY };
    assert_eq!(found, Err(refused));
}

/// The straight line is no geodesic here, so that a first step cannot be the last.
#[test]
fn steps_that_do_not_converge_are_an_error_with_the_correction() {
    match over_the_bump(&Collocation { iterations: 1, ..Collocation::default() }) {
        Err(CollocationError::NoConvergence { intervals: 16, correction, iterations: 1 }) => {
            assert!(correction > 1e-3, "{correction}");
        }
        other => panic!("{other:?}"),
    }
}

/// Three methods for the same question, where the ends lie askew and nobody knows the answer. The
/// minimiser of `N = 1024` chords is extrapolated; its error is estimated, and doubled here, since
/// the estimate is no bound.
#[test]
fn three_methods_agree_on_the_distance_between_balls() {
    #[track_caller]
    fn check(metric: impl Metric<2>, a: Ball<2>, b: Ball<2>) {
        let ends = Ends::new(a, b).expect("bounded");
        let shot = shoot(&metric, &ends, &Shooting::default()).expect("a shot").geodesic;
        let path = collocate(&metric, &ends, &Collocation::default()).expect("a path");
        assert!((path.length / shot.length() - 1.0).abs() < 2e-9);
        let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 1024).expect("a line");
        let estimate = line.distance_squared_estimate().expect("several grids");
        let apart = (shot.energy() - estimate.value).abs();
        let allowed = 2.0 * estimate.error + 2e-9 * estimate.value;
        assert!(apart < allowed, "{} for {estimate:?}", shot.energy());
        assert!(estimate.error < 1e-6 * estimate.value, "{estimate:?}");
    }
    let ball = |centre: [f64; 2], radius| Ball::new(centre, radius).expect("a radius");
    check(crate::problems::swirl(), ball([-1.0, 0.3], 0.2), ball([0.9, 0.4], 0.3));
    check(crate::problems::shear(), ball([0.2, -0.5], 0.3), ball([1.5, 1.0], 0.2));
    check(tautline::gallery::Hyperbolic, ball([-0.4, 0.1], 0.1), ball([0.3, 0.5], 0.2));
}
