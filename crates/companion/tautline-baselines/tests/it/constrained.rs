//! Minimisers on a surface.

use std::ops::ControlFlow;

use tautline::{
    Iterate, Metric, PointSequence, Prepared, Rule, SMatrix, SVector, Scalar,
    gallery::{Constant, CoupledCosines},
};
use tautline_baselines::descent::{
    Constrained, ConstrainedError, DescentError, Ended, Equality, Limits,
    constrained_dynamic_programming,
};

const LIMITS: Limits = Limits { tolerance: 1e-7, iterations: 500 };
const FEASIBILITY: f64 = 1e-11;

pub(crate) struct UnitSphere;

impl Equality<3> for UnitSphere {
    fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
        x[0].sqr() + x[1].sqr() + x[2].sqr() - 1.0
    }
}

pub(crate) fn solve(
    metric: impl Metric<3>,
    rule: Rule,
    start: PointSequence<3>,
    constraint: &impl Equality<3>,
) -> Result<Constrained<3>, ConstrainedError> {
    descend(metric, rule, start, constraint, FEASIBILITY)
}

pub(crate) fn descend<const D: usize>(
    metric: impl Metric<D>,
    rule: Rule,
    start: PointSequence<D>,
    constraint: &impl Equality<D>,
    feasibility: f64,
) -> Result<Constrained<D>, ConstrainedError> {
    let metric = Prepared::new(metric);
    let watch = &mut |_: &Iterate<'_, D>| ControlFlow::Continue(());
    constrained_dynamic_programming(&metric, rule, start, constraint, feasibility, &LIMITS, watch)
}

/// The relative error of the energy of a constrained minimiser. A residual `r` leaves an excess of `r²`
/// times what the second variation is softer than that of a flat segment: `π²/(π² − α²) = 2.7` for an
/// arc `α = 5/2` of the circle, and a hundred is allowed. Where the constraint is off by `v`, the energy
/// changes by `Σ |λₙ| v` to first order, which is far more.
pub(crate) fn energy_tolerance(found: &Constrained<3>) -> f64 {
    let forces: f64 = found.multipliers.iter().map(|multiplier| multiplier.abs()).sum();
    100.0 * LIMITS.tolerance.powi(2) + 1.1 * forces * FEASIBILITY / found.descended.energy
}

fn flat() -> Constant<3> {
    Constant::new(SMatrix::identity()).expect("definite")
}

/// Returns a line to the far end of an arc `α`, far inside the sphere, and bent to one side so that
/// it does not meet the centre.
fn bent(alpha: f64, n: usize) -> PointSequence<3> {
    let a = SVector::from([1.0, 0.0, 0.0]);
    let b = SVector::from([alpha.cos(), 0.6 * alpha.sin(), 0.8 * alpha.sin()]);
    let at = |k: usize| {
        let t = k as f64 / n as f64;
        a * (1.0 - t) + b * t + SVector::from([0.0, 0.1, -0.2]) * (t * (1.0 - t))
    };
    PointSequence::new((0..=n).map(at).collect()).expect("finite")
}

/// On the unit sphere the least sum of squares of `N` chords is that of equal chords of the great
/// circle: `E_N = (2 N sin(α/2N))²` for an arc `α`.
#[test]
fn on_a_sphere_it_is_the_great_circle() {
    for (alpha, n) in [(1.0_f64, 2), (1.0, 40), (2.5, 3), (2.5, 40), (2.5, 200)] {
        let start = bent(alpha, n);
        for found in [
            solve(flat(), Rule::TRAPEZOIDAL, start.clone(), &UnitSphere),
            solve(flat(), Rule::LEFT_ENDPOINT, start, &UnitSphere),
        ] {
            let found = found.expect("a metric");
            let what = format!(
                "{alpha}, N = {n}: {:?}, residual {:e} of {:e}, violation {:e}",
                found.descended.ended,
                found.descended.residual,
                found.descended.residual_floor,
                found.violation
            );
            assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
            assert!(found.violation <= FEASIBILITY, "{what}: {:e}", found.violation);
            let expected = (2.0 * n as f64 * (alpha / (2.0 * n as f64)).sin()).powi(2);
            let error = found.descended.energy / expected - 1.0;
            let tolerance = energy_tolerance(&found);
            assert!(error.abs() <= tolerance, "{what}: {error:e} {tolerance:e}");
            // All points are in the plane of the great circle. Off it, a force ρ causes the
            // displacement η with −η'' − α²η = ρ, which is at most √2 |ρ|/(π² − α²) but for higher
            // modes; with |ρ| = αr that is r for α = 5/2, and a fifth more with three chords.
            let normal = SVector::from([0.0, 0.8, -0.6]);
            let off = found.descended.sequence.points().iter().map(|x| normal.dot(x).abs());
            assert!(off.fold(0.0, f64::max) <= 1.2 * LIMITS.tolerance, "{what}");
            // The derivative of the energy is 4N(1 − cos(α/N)) xₙ, and that of the constraint 2xₙ. A
            // residual r allows a force of √N αr at one point, which is N times the error of λ. The
            // points that it moves along the circle add as much times 2α/√3N, in squares; and three
            // points that are off by v/2 change λ by 2Nv.
            let chords = n as f64;
            let lambda = -2.0 * chords * (1.0 - (alpha / chords).cos());
            let along = (1.0 + 4.0 * alpha.powi(2) / (3.0 * chords)).sqrt();
            let force = alpha * LIMITS.tolerance / chords.sqrt() * along;
            let tolerance = force + 2.0 * chords * FEASIBILITY;
            for multiplier in &found.multipliers {
                assert!((multiplier - lambda).abs() <= tolerance, "{what}: {multiplier} {lambda}");
            }
        }
    }
}

/// In other units of the metric and of the constraint, all is the same up to the unit: powers of two
/// do not even change the rounding.
#[test]
fn units_change_nothing() {
    struct Scaled<'a, C>(&'a C, f64);
    impl<C: Equality<3>> Equality<3> for Scaled<'_, C> {
        fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
            self.0.value(x) * self.1
        }
    }
    fn compare(surface: &impl Equality<3>, start: &PointSequence<3>) {
        let run = |metric: f64, constraint: f64| {
            let metric = Constant::new(SMatrix::identity() * metric).expect("definite");
            let metric = Prepared::new(metric);
            let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
            let (surface, feasibility) = (&Scaled(surface, constraint), FEASIBILITY * constraint);
            let (rule, start) = (Rule::TRAPEZOIDAL, start.clone());
            let found = constrained_dynamic_programming(
                &metric,
                rule,
                start,
                surface,
                feasibility,
                &LIMITS,
                watch,
            );
            found.expect("a metric")
        };
        let expected = run(1.0, 1.0);
        let (large, small) = (2.0_f64.powi(40), 2.0_f64.powi(-40));
        for (metric, constraint) in [(large, 1.0), (small, 1.0), (1.0, large), (1.0, small)] {
            let found = run(metric, constraint);
            let what = format!("{metric:e} {constraint:e}: {:?}", found.descended.ended);
            assert_eq!(found.descended.sequence, expected.descended.sequence, "{what}");
            assert_eq!(found.descended.iterations, expected.descended.iterations, "{what}");
            assert_eq!(found.descended.energy, expected.descended.energy * metric, "{what}");
            let multipliers: Vec<f64> =
                expected.multipliers.iter().map(|lambda| lambda * metric / constraint).collect();
            assert_eq!(found.multipliers, multipliers, "{what}");
        }
    }
    compare(&UnitSphere, &bent(2.5, 200));
    // Between two spheres the Lagrangian is indefinite, and shifted.
    let start = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 2.0, 0.0], 41).expect("finite");
    compare(&crate::impossible_constraints::TwoSpheres, &start);
}

/// Nothing is asked for but what rounding allows.
#[test]
fn tolerances_of_zero_end_at_rounding() {
    for n in [2, 3, 40, 1000] {
        let metric = Prepared::new(CoupledCosines);
        let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
        let limits = Limits { tolerance: 0.0, ..LIMITS };
        let (rule, start, sphere) = (Rule::TRAPEZOIDAL, bent(2.5, n), &UnitSphere);
        let found =
            constrained_dynamic_programming(&metric, rule, start, sphere, 0.0, &limits, watch);
        let found = found.expect("a metric");
        let what = format!("{n}: {:?} {}", found.descended.ended, found.descended.iterations);
        assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
        // Values and slopes of size 2, rounded a few times in each of three coordinates.
        assert!(found.violation < 1e-14, "{what}: {:e}", found.violation);
    }
}

/// A sphere a thousand radii from the origin: its points are rounded by `10⁻¹³` and more, which the
/// constraint and its multipliers feel more than the energy does.
#[test]
fn a_sphere_far_from_the_origin_has_the_same_great_circles() {
    struct Far(f64);
    impl Equality<3> for Far {
        fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
            UnitSphere.value(&x.map(|x| x - self.0))
        }
    }
    let n = 40;
    let expected = (2.0 * n as f64 * (1.25 / n as f64).sin()).powi(2);
    for shift in [1e3, 1e5, 1e7] {
        let moved = bent(2.5, n).points().iter().map(|x| x.add_scalar(shift)).collect();
        let start = PointSequence::new(moved).expect("finite");
        let metric = Prepared::new(flat());
        let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
        let far = &Far(shift);
        let limits = Limits { tolerance: 0.0, ..LIMITS };
        let found = constrained_dynamic_programming(
            &metric,
            Rule::TRAPEZOIDAL,
            start,
            far,
            0.0,
            &limits,
            watch,
        );
        let found = found.expect("a metric");
        let what = format!("{shift}: {:?} {}", found.descended.ended, found.descended.iterations);
        assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
        assert!(found.descended.iterations <= 40, "{what}");
        // A point is rounded by at most 2⁻⁵³ times twice the shift, in three coordinates, and slopes
        // are below 2; what holds is 0 up to eight such roundings.
        assert!(found.violation <= 1e-14 * shift, "{what}: {:e}", found.violation);
        // A violation v moves a point by v/2, and chords shorten by as much.
        let error = found.descended.energy / expected - 1.0;
        assert!(error.abs() <= 1e-14 * shift, "{what}: {error:e}");
    }
}

/// The first penalty and the shifts are relative to a bend of the whole curve, so that a long
/// sequence takes about as many steps as a short one, also from far off. With a penalty that begins
/// as stiff as the energy between neighbours the second start has not arrived after 500 steps.
#[test]
fn long_sequences_take_as_few_steps() {
    let (a, b) = (SVector::from([-0.7, 0.0, 0.1]), SVector::from([1.0, -0.3, 0.2]));
    let (a, b, bump) = (a.normalize(), b.normalize(), SVector::from([0.3, 1.1, -1.6]));
    let other = |n: usize| {
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            a.lerp(&b, t) + bump * (t * (1.0 - t))
        };
        PointSequence::new((0..=n).map(at).collect()).expect("finite")
    };
    for n in [50, 400, 3000] {
        for start in [bent(2.5, n), other(n)] {
            let found =
                solve(CoupledCosines, Rule::TRAPEZOIDAL, start, &UnitSphere).expect("a metric");
            let what = format!("{n}: {:?} {}", found.descended.ended, found.descended.iterations);
            assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
            assert!(found.descended.iterations <= 40, "{what}");
        }
    }
}

/// A loop on a sphere shrinks to a point: its chords are as short as its points are off the sphere,
/// and none of them is called a leap.
#[test]
fn a_loop_shrinks_to_a_point() {
    let a = SVector::from([0.6, 0.0, 0.8]);
    let at = |k: usize| {
        let angle = k as f64 * (std::f64::consts::TAU / 30.0);
        a + SVector::from([0.0, angle.sin(), angle.cos() - 1.0]) * 0.2
    };
    let mut points: Vec<_> = (0..30).map(at).collect();
    points.push(a);
    let start = PointSequence::new(points).expect("finite");
    let found = solve(CoupledCosines, Rule::TRAPEZOIDAL, start, &UnitSphere).expect("a metric");
    assert_eq!(found.descended.ended, Ended::Stationary, "{found:?}");
    // The residual of a loop is at least 1, however small the loop is, until rounding causes as much: where
    // √E is N²ε times the root of 3/2 and of tr H/3, which is below 2.
    let rounding = (900.0 * f64::EPSILON).powi(2) * 3.0;
    assert!(found.descended.energy < rounding, "{:e}", found.descended.energy);
}

/// The metric waves over a thousandth of the radius: a rounding of a point changes its slope by
/// `10⁻³ · 10⁶ · 10⁻¹⁶`, more than the floor of the residual, and no other point is better.
#[test]
fn where_rounding_hides_the_residual_a_descent_stalls() {
    struct Waves;
    impl Metric<3> for Waves {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            SMatrix::from_diagonal_element((x[1] * 1e3).sin() * 1e-3 + 2.0)
        }
    }
    let metric = Prepared::new(Waves);
    let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
    let limits = Limits { tolerance: 0.0, ..LIMITS };
    let (rule, start, sphere) = (Rule::TRAPEZOIDAL, bent(2.0, 3), &UnitSphere);
    let found = constrained_dynamic_programming(&metric, rule, start, sphere, 0.0, &limits, watch);
    let found = found.expect("a metric").descended;
    assert_eq!(found.ended, Ended::Stalled, "{found:?}");
    assert!(found.residual < 1e-13 && found.iterations < 200, "{found:?}");
}

#[test]
fn an_end_off_the_surface_is_an_error_and_an_end_of_time_is_not() {
    let off = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 1.1, 0.0], 8).expect("finite");
    let refused = solve(flat(), Rule::TRAPEZOIDAL, off.clone(), &UnitSphere);
    let Err(ConstrainedError::End { end: "last", value: violation, .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!((violation - 0.21).abs() < 1e-15);
    let metric = Prepared::new(flat());
    let start = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], 8).expect("finite");
    let mut shown = None;
    let mut run = |limits: &Limits, end: usize| {
        let watch = &mut |iterate: &Iterate<'_, 3>| {
            shown = Some((iterate.sequence.clone(), iterate.energy, iterate.residual));
            if iterate.iteration == end {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let (rule, sphere) = (Rule::TRAPEZOIDAL, &UnitSphere);
        constrained_dynamic_programming(&metric, rule, start.clone(), sphere, 1e-9, limits, watch)
    };
    let found = run(&LIMITS, 3).expect("a metric");
    assert_eq!((found.descended.ended, found.descended.iterations), (Ended::Interrupted, 3));
    // It tells how far it is from the surface.
    assert!(
        found.violation > 1e-9 && found.multipliers.iter().any(|multiplier| *multiplier != 0.0)
    );
    let sizes = found.descended.sequence.points().iter().map(|x| UnitSphere.value(x).abs());
    assert_eq!(found.violation, sizes.fold(0.0, f64::max));
    let limited = run(&Limits { iterations: 3, ..LIMITS }, 9).expect("a metric");
    assert_eq!(limited.descended.ended, Ended::IterationLimit);
    assert_eq!(
        (&limited.descended.sequence, limited.violation),
        (&found.descended.sequence, found.violation)
    );
    let nan = Limits { tolerance: f64::NAN, ..LIMITS };
    let refused = run(&nan, 3);
    let expected = DescentError::Tolerance { tolerance: f64::NAN };
    assert_eq!(
        format!("{refused:?}"),
        format!("{:?}", Err::<(), _>(ConstrainedError::from(expected)))
    );
    // What is returned is what was shown last.
    let last = (limited.descended.sequence, limited.descended.energy, limited.descended.residual);
    assert_eq!(shown, Some(last));
}
