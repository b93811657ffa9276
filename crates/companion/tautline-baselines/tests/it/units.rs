//! Other units of the metric, of length and of time, and another origin: nothing changes but the units.

use std::ops::ControlFlow;

use nalgebra::{SMatrix, SVector};
use tautline::gallery::Bump;
use tautline::{Batches, Iterate, Metric, PointSequence, Prepared, Rule, Scalar, norm_squared};
use tautline_baselines::descent::{
    Descended, DescentError, Ended, Limits, SecondOrder, dynamic_programming, sobolev_descent,
};
use tautline_baselines::shooting::{Integration, exponential};

use crate::problems::{Exact, Vector, for_each_problem};

/// The metric `f H((x − o)/ℓ)` for a factor `f`, an origin `o` and a unit of length `ℓ`.
struct InUnits<'a, M> {
    metric: &'a M,
    factor: f64,
    length: f64,
    origin: f64,
}

impl<M: Metric<2>> Metric<2> for InUnits<'_, M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let h = self.metric.gram(&x.map(|x| (x - self.origin) / self.length));
        h.map(|entry| entry * self.factor)
    }
}

/// Powers of two do not even change the rounding.
const LARGE: f64 = (1_u64 << 40) as f64;

/// Runs a descent from a line that is off the top of a bump, in a unit of the metric.
fn off_the_top(
    factor: f64,
    descend: impl FnOnce(&dyn Batches<2>, PointSequence<2>) -> Result<Descended<2>, DescentError>,
) -> Descended<2> {
    let bump = Bump::new(4.0, 0.5).expect("a width");
    let metric = Prepared::new(InUnits { metric: &bump, factor, length: 1.0, origin: 0.0 });
    let at = |k: usize| {
        let t = k as f64 / 40.0;
        SVector::from([3.0 * t - 1.5, 0.1 * t * (1.0 - t)])
    };
    let start = PointSequence::new((0..=40).map(at).collect()).expect("finite");
    descend(&metric, start).expect("a metric")
}

fn assert_same_in_other_units(run: impl Fn(f64) -> Descended<2>) {
    let expected = run(1.0);
    assert_eq!(expected.ended, Ended::Stationary);
    // It leaves the way over the top, whose energy is 64.
    assert!(expected.energy < 32.0, "{}", expected.energy);
    for factor in [LARGE, 1.0 / LARGE] {
        let found = run(factor);
        assert_eq!(found.iterations, expected.iterations, "{factor}");
        assert_eq!(found.sequence, expected.sequence, "{factor}");
        assert_eq!(found.energy, factor * expected.energy, "{factor}");
    }
}

/// Off the top of a bump the Hessian is indefinite, so that it is shifted.
#[test]
fn dynamic_programming_takes_the_same_steps_in_other_units() {
    assert_same_in_other_units(|factor| {
        off_the_top(factor, |metric, start| {
            let (limits, full) = (Limits::default(), SecondOrder::Full);
            let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
            dynamic_programming(metric, Rule::TRAPEZOIDAL, start, full, &limits, watch)
        })
    });
}

/// The length of a step follows from the step before, in the unit of that.
#[test]
fn a_sobolev_descent_takes_the_same_steps_in_other_units() {
    assert_same_in_other_units(|factor| {
        off_the_top(factor, |metric, start| {
            let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
            sobolev_descent(metric, Rule::TRAPEZOIDAL, start, &Limits::default(), watch)
        })
    });
}

#[test]
fn a_geodesic_is_the_same_in_other_units() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, v) = (Vector::from(x), metric.exact_logarithm(&x.into(), &y.into()));
        // Errors beyond rounding, so that there is a drift to compare.
        let options = Integration { tolerance: 1e-6, ..Integration::default() };
        let run = |factor: f64, length: f64| {
            let there = InUnits { metric, factor, length, origin: 0.0 };
            exponential(&there, &(x * length), &(v * length), &options).expect("complete")
        };
        let expected = run(1.0, 1.0);
        assert!(expected.drift() > 1e-14, "{name}: {:e}", expected.drift());
        for (factor, length) in [(LARGE, 1.0), (1.0 / LARGE, 1.0), (1.0, LARGE), (1.0, 1.0 / LARGE)]
        {
            let (found, what) = (run(factor, length), format!("{name}: {factor}, {length}"));
            assert_eq!(found.steps(), expected.steps(), "{what}");
            assert_eq!(found.end(), expected.end() * length, "{what}");
            assert_eq!(found.final_velocity(), expected.final_velocity() * length, "{what}");
            assert_eq!(found.energy(), expected.energy() * factor * length * length, "{what}");
            assert_eq!(found.drift(), expected.drift(), "{what}");
            assert_eq!(found.end_by_velocity(), expected.end_by_velocity(), "{what}");
            assert_eq!(found.end_by_start(), expected.end_by_start(), "{what}");
        }
    }
    for_each_problem!(check);
}

/// Coordinates near 1024 are rounded by `10⁻¹³`, and a step of the integrator allows itself `10⁻⁹`
/// of the speed: neither changes a step.
#[test]
fn a_geodesic_far_from_the_origin_takes_the_same_steps() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, v) = (Vector::from(x), metric.exact_logarithm(&x.into(), &y.into()));
        let options = Integration { tolerance: 1e-9, ..Integration::default() };
        let run = |origin: f64| {
            let there = InUnits { metric, factor: 1.0, length: 1.0, origin };
            exponential(&there, &x.add_scalar(origin), &v, &options).expect("complete")
        };
        let (near, far) = (run(0.0), run(1024.0));
        assert_eq!(far.steps(), near.steps(), "{name}");
        let apart = far.end().add_scalar(-1024.0) - near.end();
        // Roundings of 10⁻¹³ in each of some ten steps, which grow by less than 10.
        assert!(apart.norm() < 1e-11, "{name}: {apart}");
    }
    for_each_problem!(check);
}

/// In half the time a geodesic with half the velocity is half as far, and its energy is a quarter.
#[test]
fn a_slower_geodesic_is_the_beginning_of_a_faster_one() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let (x, v) = (Vector::from(x), metric.exact_logarithm(&x.into(), &y.into()));
        let options = Integration::default();
        let fast = exponential(metric, &x, &v, &options).expect("complete");
        let slow = exponential(metric, &x, &(v * 0.5), &options).expect("complete");
        // Each is off by some ten steps of 10⁻¹² of the speed, which is below 3: less than half of
        // 10⁻¹⁰. Of the velocity see `the_exponential_is_the_exact_one_all_along`.
        let apart = fast.position(0.5).expect("a time") - slow.end();
        assert!(apart.norm() < 1e-10, "{name}: {apart}");
        let apart = fast.velocity(0.5).expect("a time") - slow.final_velocity() * 2.0;
        assert!(apart.norm() < 1e-9, "{name}: {apart}");
        assert_eq!(fast.energy(), 4.0 * slow.energy(), "{name}");
        assert_eq!(fast.length(), 2.0 * slow.length(), "{name}");
    }
    for_each_problem!(check);
}

/// The drift is the relative change of the square of the speed, whichever way it goes.
#[test]
fn the_drift_is_that_of_the_squared_speed() {
    fn check(name: &str, metric: &impl Exact, x: [f64; 2], y: [f64; 2]) {
        let mut signs = Vec::new();
        for (x, y) in [(Vector::from(x), Vector::from(y)), (y.into(), x.into())] {
            let v = metric.exact_logarithm(&x, &y);
            for tolerance in [1e-2, 1e-3, 1e-4, 1e-5] {
                let options = Integration { tolerance, ..Integration::default() };
                let geodesic = exponential(metric, &x, &v, &options).expect("complete");
                let first = norm_squared(metric, &x, &v);
                let last = norm_squared(metric, &geodesic.end(), &geodesic.final_velocity());
                assert_eq!(geodesic.drift(), (last - first).abs() / first, "{name}");
                signs.push(last > first);
            }
        }
        assert!(signs.contains(&true) && signs.contains(&false), "{name}: {signs:?}");
    }
    for_each_problem!(check);
}
