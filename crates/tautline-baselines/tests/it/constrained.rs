//! Minimisers on a surface.

use std::ops::ControlFlow;

use tautline::{
    Ends, Iterate, LeftEndpoint, Metric, Options, PointSequence, Prepared, Rule, SMatrix, SVector,
    Scalar, Starts, Trapezoidal,
    gallery::{Constant, CoupledCosines},
    minimise,
};
use tautline_baselines::descent::{
    Constrained, ConstrainedError, DescentError, Ended, Equality, Limits,
    constrained_dynamic_programming,
};

const LIMITS: Limits = Limits { tolerance: 1e-7, iterations: 500 };
const FEASIBILITY: f64 = 1e-11;

struct UnitSphere;

impl Equality<3> for UnitSphere {
    fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
        x[0].sqr() + x[1].sqr() + x[2].sqr() - 1.0
    }
}

/// The plane `x₃ = 0.3 x₁ − 0.2 x₂`, with the normal `(0.3, −0.2, −1)` times ten.
struct Plane;

impl Equality<3> for Plane {
    fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
        x[0] * 3.0 - x[1] * 2.0 - x[2] * 10.0
    }
}

fn solve<M: Metric<3>>(
    metric: M,
    rule: impl Rule,
    start: PointSequence<3>,
    constraint: &impl Equality<3>,
) -> Result<Constrained<3>, ConstrainedError> {
    let metric = Prepared::new(metric);
    let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
    constrained_dynamic_programming(&metric, rule, start, constraint, FEASIBILITY, &LIMITS, watch)
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
            solve(flat(), Trapezoidal, start.clone(), &UnitSphere),
            solve(flat(), LeftEndpoint, start, &UnitSphere),
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
            // The residual is 1e-7, of which the energy is off by the square; a violation of 1e-11
            // shortens each of the n chords by as much, relative to the radius.
            assert!(error.abs() <= 1e-10, "{what}: {error:e}");
            // All points are in the plane of the great circle.
            let normal = SVector::from([0.0, 0.8, -0.6]);
            let off = found.descended.sequence.points().iter().map(|x| normal.dot(x).abs());
            assert!(off.fold(0.0, f64::max) <= 1e-7, "{what}");
        }
    }
}

/// The coupled cosines on a plane: a metric of two variables.
struct OnThePlane;

impl Metric<2> for OnThePlane {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let in_space = SVector::from([x[0], x[1], x[0] * 0.3 - x[1] * 0.2]);
        let h = CoupledCosines.gram(&in_space);
        let tangents = [[1.0, 0.0, 0.3], [0.0, 1.0, -0.2]];
        SMatrix::from_fn(|i, j| {
            let mut sum = S::constant(0.0);
            for k in 0..3 {
                for l in 0..3 {
                    sum += h[(k, l)] * (tangents[i][k] * tangents[j][l]);
                }
            }
            sum
        })
    }
}

/// In coordinates on the plane the problem has no constraint, and the structured solver finds the
/// same energy.
#[test]
fn on_a_plane_it_is_the_minimum_in_coordinates() {
    fn compare(rule: impl Rule) {
        let (a, b, n) = ([-1.0, 0.3], [2.0, 1.5], 32);
        let start = PointSequence::straight(a, b, n).expect("finite");
        let ends = Ends::points(a, b).expect("finite");
        let only = Options { starts: Starts::Only(vec![start]), ..Options::default() };
        let expected = minimise(&OnThePlane, &ends, rule, n, &only).expect("a metric").energy;
        let lift = |x: [f64; 2]| [x[0], x[1], 0.3 * x[0] - 0.2 * x[1]];
        let start = PointSequence::straight(lift(a), lift(b), n).expect("finite");
        // The energy in space has a lower minimum between the same points.
        let ends = Ends::points(lift(a), lift(b)).expect("finite");
        let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
        let free = minimise(&CoupledCosines, &ends, rule, n, &only).expect("a metric").energy;
        let found = solve(CoupledCosines, rule, start, &Plane).expect("a metric");
        let what = format!(
            "{rule:?}: residual {:e} of {:e}, violation {:e}",
            found.descended.residual, found.descended.residual_floor, found.violation
        );
        assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
        let error = found.descended.energy / expected - 1.0;
        assert!(error.abs() <= 1e-10, "{rule:?}: {error:e}");
        assert!(free < expected * (1.0 - 1e-6), "{rule:?}: {free} {expected}");
        // The multipliers are the forces that hold the curve in its plane.
        assert!(found.multipliers.iter().any(|multiplier| multiplier.abs() > 1e-4));
    }
    compare(Trapezoidal);
    compare(LeftEndpoint);
}

/// The unit sphere under the coupled cosines, in stereographic coordinates
/// `x = (2y₁, 2y₂, |y|² − 1)/(1 + |y|²)`.
struct OnTheSphere;

impl OnTheSphere {
    fn lift<S: Scalar>(y: &SVector<S, 2>) -> SVector<S, 3> {
        let s = S::constant(1.0) / (y[0].sqr() + y[1].sqr() + 1.0);
        SVector::from([y[0] * s * 2.0, y[1] * s * 2.0, -s * 2.0 + 1.0])
    }
}

impl Metric<2> for OnTheSphere {
    fn gram<S: Scalar>(&self, y: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let h = CoupledCosines.gram(&Self::lift(y));
        let s = S::constant(1.0) / (y[0].sqr() + y[1].sqr() + 1.0);
        let tangents: [SVector<S, 3>; 2] = std::array::from_fn(|j| {
            SVector::from_fn(|i, _| {
                let turn = s.sqr() * y[j] * 4.0;
                let of_point = if i < 2 { -turn * y[i] } else { turn };
                if i == j { of_point + s * 2.0 } else { of_point }
            })
        });
        SMatrix::from_fn(|i, j| {
            let mut sum = S::constant(0.0);
            for k in 0..3 {
                for l in 0..3 {
                    sum += h[(k, l)] * tangents[i][k] * tangents[j][l];
                }
            }
            sum
        })
    }
}

/// Under a metric that varies, the chords in space and those in a chart have different energies, and
/// one limit. The errors of the trapezoidal rule are a series in `1/N²`, of which Richardson's
/// extrapolation takes off three terms: what is left is of the order `512⁻²·256⁻²·128⁻²·64⁻²`.
#[test]
fn on_a_sphere_in_another_metric_the_limit_is_that_in_a_chart() {
    let (a, b) = ([0.9, 0.2], [-0.5, 0.8]);
    let along = |k: usize, n: usize| SVector::from(a).lerp(&b.into(), k as f64 / n as f64);
    let grids = [64, 128, 256, 512];
    let energies = grids.map(|n| {
        let chart = PointSequence::new((0..=n).map(|k| along(k, n)).collect()).expect("finite");
        let lifted = chart.points().iter().map(OnTheSphere::lift).collect();
        let ends = Ends::points(a, b).expect("finite");
        let only = Options { starts: Starts::Only(vec![chart]), ..Options::default() };
        let found = minimise(&OnTheSphere, &ends, Trapezoidal, n, &only).expect("a metric");
        let lifted = PointSequence::new(lifted).expect("finite");
        let on_sphere = solve(CoupledCosines, Trapezoidal, lifted, &UnitSphere).expect("a metric");
        assert_eq!(on_sphere.descended.ended, Ended::Stationary);
        [found.energy, on_sphere.descended.energy]
    });
    // The energies on the finest grid differ by far more than the limits.
    let [chart, in_space] = energies[3];
    assert!((in_space / chart - 1.0).abs() > 1e-9, "{in_space} {chart}");
    let limit = |which: usize| {
        let mut table = energies.map(|energies| energies[which]).to_vec();
        let mut factor = 4.0;
        while table.len() > 1 {
            let pairs = table.windows(2);
            table = pairs.map(|e| e[1] + (e[1] - e[0]) / (factor - 1.0)).collect();
            factor *= 4.0;
        }
        table[0]
    };
    let error = limit(1) / limit(0) - 1.0;
    assert!(error.abs() <= 1e-10, "{error:e}");
}

/// In other units of the metric and of the constraint, all is the same up to the unit: powers of two
/// do not even change the rounding.
#[test]
fn units_change_nothing() {
    struct Scaled(f64);
    impl Equality<3> for Scaled {
        fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
            UnitSphere.value(x) * self.0
        }
    }
    let start = bent(2.5, 200);
    let run = |metric: f64, constraint: f64| {
        let metric = Constant::new(SMatrix::identity() * metric).expect("definite");
        let metric = Prepared::new(metric);
        let watch = &mut |_: &Iterate<'_, 3>| ControlFlow::Continue(());
        let (surface, feasibility) = (&Scaled(constraint), FEASIBILITY * constraint);
        constrained_dynamic_programming(
            &metric,
            Trapezoidal,
            start.clone(),
            surface,
            feasibility,
            &LIMITS,
            watch,
        )
        .expect("a metric")
    };
    let expected = run(1.0, 1.0);
    // The start is far inside, where the Lagrangian is indefinite: shifts are scaled too.
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

/// The first penalty and the shifts are relative to a bend of the whole curve, so that a long
/// sequence takes about as many steps as a short one.
#[test]
fn long_sequences_take_as_few_steps() {
    for n in [50, 3000] {
        let found = solve(CoupledCosines, Trapezoidal, bent(2.5, n), &UnitSphere);
        let found = found.expect("a metric");
        let what = format!("{n}: {:?} {}", found.descended.ended, found.descended.iterations);
        assert_eq!(found.descended.ended, Ended::Stationary, "{what}");
        assert!(found.descended.iterations <= 40, "{what}");
    }
}

#[test]
fn an_end_off_the_surface_is_an_error_and_an_end_of_time_is_not() {
    let off = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 1.1, 0.0], 8).expect("finite");
    let refused = solve(flat(), Trapezoidal, off.clone(), &UnitSphere);
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
        let (rule, sphere) = (Trapezoidal, &UnitSphere);
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
