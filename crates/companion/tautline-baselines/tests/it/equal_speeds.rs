//! Minimisers among the sequences of equal speeds.

use std::ops::ControlFlow;

use tautline::{
    Ends, Metric, Options, PointSequence, Prepared, Rule, SVector,
    gallery::{Bump, CoupledCosines, Hill, Separable, Swirl, Valleys},
    minimise,
};
use tautline_baselines::{
    descent::{DescentError, Ended, Limits},
    equal_speeds::{EqualSpeeds, equal_speeds},
};

const LIMITS: Limits = Limits { tolerance: 1e-11, iterations: 200 };

fn from<M: Metric<D>, const D: usize>(
    metric: &M,
    rule: Rule,
    start: PointSequence<D>,
) -> EqualSpeeds<D> {
    let prepared = Prepared::new(metric);
    let watch = &mut |_: &tautline::Iterate<'_, D>| ControlFlow::Continue(());
    equal_speeds(&prepared, rule, start, &LIMITS, watch).expect("a metric")
}

/// From the minimiser without constraints, by one rule on all grids.
fn compare<M: Metric<D>, const D: usize>(
    name: &str,
    rule: Rule,
    metric: &M,
    a: [f64; D],
    b: [f64; D],
) {
    let ends = Ends::points(SVector::from(a), SVector::from(b)).expect("finite");
    for n in [2, 3, 16, 128, 1024] {
        let free = minimise(metric, &ends, rule, n, &Options::default()).expect("a metric");
        let found = from(metric, rule, free.sequence);
        let EqualSpeeds { descended, speed_residual, .. } = found;
        let what = format!("{name}, {rule}, N = {n}: {:?}", descended.ended);
        assert!(speed_residual <= 1e-10, "{what}: {speed_residual:e}");
        let speeds = rule.speeds(metric, &descended.sequence);
        let mean = descended.energy.sqrt();
        // The speeds of the rule itself, with one more rounding.
        assert!(speeds.iter().all(|speed| (speed / mean - 1.0).abs() <= 1.1e-10), "{what}");
        // Fewer sequences have no smaller minimum; energies have a relative rounding of 1e-15 or so.
        assert!(descended.energy >= free.energy * (1.0 - 1e-13), "{what}");
        // The speeds of the free minimiser differ by O(1/N) for the left rule and O(1/N²) for the
        // other, and the energy is quadratic in what has to change.
        assert!(
            descended.residual <= 1e-11_f64.max(descended.residual_floor * 10.0),
            "{what}: {:e} {:e}",
            descended.residual,
            descended.residual_floor
        );
    }
}

fn both_rules<M: Metric<D>, const D: usize>(name: &str, metric: M, a: [f64; D], b: [f64; D]) {
    compare(name, Rule::LEFT_ENDPOINT, &metric, a, b);
    compare(name, Rule::TRAPEZOIDAL, &metric, a, b);
}

#[test]
fn speeds_are_equal_and_the_energy_is_above_the_free_minimum() {
    both_rules("valleys", Valleys, [0.3, 0.0], [2.5, 1.5]);
    both_rules("swirl", Swirl::new(0.5, 1.0).expect("a width"), [-1.0, 0.1], [1.2, -0.2]);
    both_rules("bump", Bump::new(4.0, 0.5).expect("a width"), [-1.5, 0.05], [1.5, -0.1]);
    both_rules("hill", Hill::new(0.5, 0.5).expect("a width"), [-1.5, 0.2], [1.5, 0.4]);
    both_rules("coupled cosines", CoupledCosines, [0.0; 3], [3.0, 2.0, -2.0]);
}

/// On a line the constraints alone fix the sequence: the points follow from the first chord, which
/// is found by bisection.
#[test]
fn on_a_line_the_sequence_is_that_of_equal_steps() {
    let metric = Separable::<1>::new([0.4], [1.0]).expect("below one");
    let (a, b, n) = (-1.0, 2.5, 12);
    let factor = |x: f64| 1.0 + 0.4 * x.sin();
    // Left endpoints: the step is the same length s divided by the factor at its first point.
    let end = |s: f64| (0..n).fold(a, |x, _| x + s / factor(x));
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if end(middle) < b { low = middle } else { high = middle }
    }
    let start = PointSequence::straight([a], [b], n).expect("finite");
    let found = from(&metric, Rule::LEFT_ENDPOINT, start);
    let mut x = a;
    for point in found.descended.sequence.points() {
        // Twelve steps, each with a few roundings, and the tolerance of the speeds.
        assert!((point[0] - x).abs() <= 1e-10, "{} {x}", point[0]);
        x += low / factor(x);
    }
    let energy = (n as f64 * low).powi(2);
    assert!((found.descended.energy / energy - 1.0).abs() <= 1e-10);
}

/// The energy cannot be lowered along the constraints: starts on either side lead to the same.
#[test]
fn other_starts_lead_to_the_same_sequence() {
    let metric = Swirl::new(0.5, 1.0).expect("a width");
    let at = |bend: f64| {
        let point = |k: usize| {
            let t = k as f64 / 24.0;
            SVector::from([2.2 * t - 1.0, 0.1 - 0.3 * t + bend * t * (1.0 - t)])
        };
        from(
            &metric,
            Rule::TRAPEZOIDAL,
            PointSequence::new((0..=24).map(point).collect()).expect("finite"),
        )
    };
    let found = [-0.3, 0.0, 0.3].map(at);
    for other in &found {
        assert_eq!(other.descended.ended, Ended::Stationary);
        let error = other.descended.energy / found[0].descended.energy - 1.0;
        // The residual is 1e-11, and the energy is off by its square.
        assert!(error.abs() <= 1e-13, "{error:e}");
    }
}

#[test]
fn what_has_no_chords_or_no_metric_is_refused_or_left_alone() {
    let flat =
        tautline::gallery::Constant::<2>::new(tautline::SMatrix::identity()).expect("definite");
    // One chord: there is nothing to do.
    let one = PointSequence::straight([0.0, 0.0], [1.0, 1.0], 1).expect("finite");
    assert_eq!(from(&flat, Rule::TRAPEZOIDAL, one).descended.ended, Ended::Stationary);
    // A chord without length has no slope, and no step leads away from it.
    let still = [[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]].map(SVector::from);
    let still = PointSequence::new(still.to_vec()).expect("finite");
    let found = from(&flat, Rule::TRAPEZOIDAL, still.clone());
    assert_eq!(found.descended.ended, Ended::Stalled);
    assert_eq!(found.descended.sequence, still);
    assert!(found.speed_residual > 0.1);
    let metric = Prepared::new(&flat);
    let nan = Limits { tolerance: f64::NAN, ..LIMITS };
    let watch = &mut |_: &tautline::Iterate<'_, 2>| ControlFlow::Continue(());
    let refused = equal_speeds(&metric, Rule::TRAPEZOIDAL, still, &nan, watch);
    assert!(matches!(refused, Err(DescentError::Tolerance { .. })));
}
