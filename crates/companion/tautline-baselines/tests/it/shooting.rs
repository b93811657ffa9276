//! Shooting: known distances, exact exponentials, sets, and every error.

use nalgebra::{SVector, vector};
use tautline::gallery::{Separable, SpherePatch, Swirl, Valleys};
use tautline::{AffineSubspace, Ball, Ends, HalfSpace, KnownDistance, Metric, Sphere};
use tautline_baselines::EquationError;
use tautline_baselines::shooting::{
    Integration, Shooting, ShootingError, exponential, logarithm, shoot,
};

use crate::problems::{Cut, Exact, HalfLine, Runaway, Vector, for_each_problem};

fn length<const D: usize>(
    metric: &impl Metric<D>,
    ends: Result<Ends<D>, tautline::SetError>,
) -> f64 {
    let shot = shoot(metric, &ends.expect("valid"), &Shooting::default()).expect("a shot");
    assert!(shot.geodesic.drift() < 1e-9, "{}", shot.geodesic.drift());
    shot.geodesic.length()
}

/// A miss of `δ` changes the length by at most `c₂^{1/2} δ`, and the shots miss by less than
/// `10⁻¹¹` of their speed; each of some ten steps adds `10⁻¹²` of it, which the variational
/// equation amplifies by less than 10.
#[test]
fn shooting_reaches_the_known_distance() {
    #[track_caller]
    fn check<const D: usize>(metric: &impl KnownDistance<D>, x: [f64; D], y: [f64; D]) {
        let d = metric.distance(&x.into(), &y.into()).expect("known");
        let found = length(metric, Ends::points(x, y));
        assert!((found / d - 1.0).abs() < 1e-9, "{found} for {d}");
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

/// The error of a step is `10⁻¹²` of the speed, which is below 3, and there are some ten steps. The
/// polynomial on a step `h < 0.2` adds `h⁸ |γ⁽⁸⁾| / (2⁸ 8!)` to the position, and `h⁷ |γ⁽⁸⁾| / 10⁵`
/// to the velocity.
#[test]
fn the_exponential_is_the_exact_one_all_along() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let v = metric.exact_logarithm(&x, &y);
        let geodesic = exponential(metric, &x, &v, &Integration::default()).expect("complete");
        assert_eq!((geodesic.start(), geodesic.initial_velocity()), (x, v));
        for k in 1..=40 {
            let t = f64::from(k) / 40.0;
            let exact = metric.exact_exponential(&x, &(v * t));
            let at = geodesic.position(t).expect("a time");
            assert!((at - exact).norm() < 1e-10, "{name}: {at} for {exact} at {t}");
            // The velocity is transported in parallel.
            let exact = metric.exact_transport(&x, &exact, &v);
            let velocity = geodesic.velocity(t).expect("a time");
            assert!((velocity - exact).norm() < 1e-9, "{name}: {velocity} for {exact} at {t}");
        }
        assert_eq!(geodesic.position(-0.1), None);
        assert_eq!(geodesic.velocity(f64::NAN), None);
    }
    for_each_problem!(check);
}

/// Central differences of step `h = 10⁻⁴` have the error `h²/6` times a third derivative below 10³.
#[test]
fn the_derivatives_of_the_end_are_those_of_differences() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let v = metric.exact_logarithm(&x, &y);
        let geodesic = exponential(metric, &x, &v, &Integration::default()).expect("complete");
        for m in 0..2 {
            let step = Vector::from_fn(|i, _| if i == m { 1e-4 } else { 0.0 });
            let at = |x, v| metric.exact_exponential(&x, &v);
            let by_velocity = (at(x, v + step) - at(x, v - step)) / 2e-4;
            let by_start = (at(x + step, v) - at(x - step, v)) / 2e-4;
            let found = geodesic.end_by_velocity().column(m) - by_velocity;
            assert!(found.norm() < 2e-6, "{name}: {found}");
            let found = geodesic.end_by_start().column(m) - by_start;
            assert!(found.norm() < 2e-6, "{name}: {found}");
        }
    }
    for_each_problem!(check);
}

/// The tolerance is derived as for the distance.
#[test]
fn the_logarithm_is_the_exact_one() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, y) = (Vector::from(x), Vector::from(y));
        let found = logarithm(metric, &x, &y, &Shooting::default()).expect("a shot");
        let exact = metric.exact_logarithm(&x, &y);
        assert!((found - exact).norm() < 1e-9 * exact.norm(), "{name}: {found} for {exact}");
    }
    for_each_problem!(check);
}

/// The distances are stated in the gallery: half-spaces are mapped to half-spaces by a separable
/// metric, and circles about the origin to themselves by a swirl.
#[test]
fn shots_between_sets_reach_the_known_distance() {
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::new([-1.0, 0.0], -3.0).expect("a normal");
    let exact = 5.0 - 3_f64.sin() + 0.5_f64.sin();
    assert!((length(&Valleys, Ends::new(ball.clone(), wall.clone())) / exact - 1.0).abs() < 1e-9);
    assert!((length(&Valleys, Ends::new(wall, ball)) / exact - 1.0).abs() < 1e-9);

    let swirl = Swirl::new(1.0, 0.8).expect("a width");
    let circle = |radius| Sphere::new([0.0, 0.0], radius).expect("a radius");
    // From any point of the small circle the large one is at the distance 2 − ½.
    let found = length(&swirl, Ends::new(circle(0.5), circle(2.0)));
    assert!((found / 1.5 - 1.0).abs() < 1e-9, "{found}");

    // The preimage of the line x₂ = 2 under a shear is itself, and that of a point is a point.
    let shear = crate::problems::shear();
    let line = AffineSubspace::new([0.0, 2.0], [[1.0, 0.0]]).expect("a direction");
    let point = tautline::Point::new([0.3, -0.4]).expect("finite");
    let found = length(&shear, Ends::new(point.clone(), line.clone()));
    assert!((found / 2.4 - 1.0).abs() < 1e-9, "{found}");
    let found = length(&shear, Ends::new(line, point));
    assert!((found / 2.4 - 1.0).abs() < 1e-9, "{found}");
}

#[test]
fn a_shot_from_a_point_to_itself_has_no_length() {
    assert_eq!(length(&Valleys, Ends::points([1.0, 2.0], [1.0, 2.0])), 0.0);
}

#[test]
fn input_that_is_not_finite_is_an_error() {
    let (x, bad) = (vector![0.0, 0.0], vector![1.0, f64::NAN]);
    let options = Integration::default();
    let coordinate = |result: Result<_, ShootingError>| match result.map(|_: Vector| ()) {
        Err(ShootingError::NotFinite { what, coordinate, .. }) => (what, coordinate),
        other => panic!("{other:?}"),
    };
    let end = |x, v| exponential(&Valleys, x, v, &options).map(|geodesic| geodesic.end());
    assert_eq!(coordinate(end(&bad, &x)), ("point", 1));
    assert_eq!(coordinate(end(&x, &bad)), ("velocity", 1));
    let between = |x, y| logarithm(&Valleys, x, y, &Shooting::default());
    assert_eq!(coordinate(between(&bad, &x)), ("first point", 1));
    assert_eq!(coordinate(between(&x, &bad)), ("second point", 1));
    let guess = Shooting { velocity: Some(bad), ..Shooting::default() };
    let found = logarithm(&Valleys, &x, &vector![1.0, 1.0], &guess);
    assert_eq!(coordinate(found), ("velocity", 1));
}

#[test]
fn a_tolerance_out_of_range_is_an_error() {
    for tolerance in [0.0, -1.0, f64::NAN, 1e-15, 1.0] {
        let options = Integration { tolerance, ..Integration::default() };
        let error = exponential(&Valleys, &vector![0.0], &vector![1.0], &options).expect_err("bad");
        assert!(matches!(error, ShootingError::Tolerance { .. }), "{error}");
    }
}

/// Along a geodesic `∫ √(1 + x⁴) dx` is linear in `t`. From 1 with the velocity −2 it decreases by
/// `2√2` until the time 1, and by `1.0894…` until the edge, since `1 + x⁴/2 − x⁸/8 + x¹²/16 − …`
/// has the integral `1 + 1/10 − 1/72 + 1/208 − …`, an alternating series between 1.086 and 1.091.
#[test]
fn a_shot_that_leaves_the_domain_says_when() {
    let shot = |v: f64| exponential(&Cut, &vector![1.0], &vector![v], &Integration::default());
    match shot(-2.0).expect_err("the edge") {
        ShootingError::LeavesTheDomain { time, source: EquationError::Metric(_) } => {
            assert!(1.086 < time * 8_f64.sqrt() && time * 8_f64.sqrt() < 1.091, "{time}");
        }
        other => panic!("{other}"),
    }
    assert!(shot(-0.5).is_ok_and(|geodesic| geodesic.end()[0] > 0.0));
    let outside = exponential(&Cut, &vector![-1.0], &vector![1.0], &Integration::default());
    assert!(matches!(outside, Err(ShootingError::LeavesTheDomain { time: 0.0, .. })));
    let ends = Ends::points([-1.0], [1.0]).expect("finite");
    let outside = shoot(&Cut, &ends, &Shooting::default());
    assert!(matches!(outside, Err(ShootingError::LeavesTheDomain { time: 0.0, .. })));
}

/// On the half-line the acceleration is infinite at the edge, which the geodesic from 1 with the
/// velocity −1 reaches at the time ⅔. A relative error of `10⁻¹²` per step moves this time by less
/// than `10⁻⁹`, and the steps shrink in proportion to the time that is left.
#[test]
fn a_geodesic_that_ends_in_finite_time_is_an_error() {
    let shot = |v: f64| exponential(&HalfLine, &vector![1.0], &vector![v], &Integration::default());
    match shot(-1.0).expect_err("the edge") {
        ShootingError::StepTooSmall { time, .. } => {
            assert!((time - 2.0 / 3.0).abs() < 1e-9, "{time}");
        }
        other => panic!("{other}"),
    }
    // Until the time 1 the velocity −½ takes x^{3/2} from 1 to ¼.
    let end = shot(-0.5).expect("it stays").end()[0];
    assert!((end - 0.25_f64.powf(2.0 / 3.0)).abs() < 1e-10, "{end}");
}

#[test]
fn a_geodesic_that_runs_to_infinity_is_an_error() {
    let shot = |v: f64| exponential(&Runaway, &vector![0.0], &vector![v], &Integration::default());
    match shot(2.0).expect_err("infinity at ½") {
        ShootingError::StepTooSmall { time, .. } => assert!((time - 0.5).abs() < 1e-6, "{time}"),
        other => panic!("{other}"),
    }
    let end = shot(0.5).expect("it stays").end()[0];
    assert!((end - 2_f64.ln()).abs() < 1e-10, "{end}");
}

#[test]
fn too_many_steps_are_an_error() {
    let options = Integration { steps: 3, ..Integration::default() };
    let found = exponential(&Valleys, &vector![0.0], &vector![9.0], &options);
    assert!(
        matches!(found, Err(ShootingError::TooManySteps { steps: 3, time }) if time < 1.0),
        "{found:?}"
    );
}

/// On the half-line no geodesic from a point right of the edge reaches a point left of it; and no
/// step of Newton's method is allowed in the second case.
#[test]
fn shots_that_miss_are_an_error_with_the_miss() {
    let ends = Ends::points([1.0], [-0.5]).expect("finite");
    let velocity: Option<SVector<f64, 1>> = Some(vector![-0.5]);
    let missed = shoot(&HalfLine, &ends, &Shooting { velocity, ..Shooting::default() });
    match missed.expect_err("out of reach") {
        ShootingError::NoConvergence { residual, .. } => assert!(residual >= 0.5, "{residual}"),
        other => panic!("{other}"),
    }
    let ends = Ends::points([0.5, 0.0], [2.5, 1.0]).expect("finite");
    let missed = shoot(&Valleys, &ends, &Shooting { iterations: 0, ..Shooting::default() });
    let Err(ShootingError::NoConvergence { iterations: 0, residual }) = missed else {
        panic!("{missed:?}");
    };
    assert!(residual > 0.01, "{residual}");
}
