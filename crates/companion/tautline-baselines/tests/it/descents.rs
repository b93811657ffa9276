//! The other minimisers of a discrete energy reach the minimum of the structured Newton method.

use std::ops::ControlFlow;

use tautline::{
    Batches, Curvature, Ends, Iterate, Metric, Options, PointSequence, Prepared, Rule, SMatrix,
    SVector, Scalar, Starts, Trace, Watcher, Workspace, gallery::*, minimise, newton_step,
};
use tautline_baselines::descent::{
    Coordinates, Descended, DescentError, Ended, Limits, SecondOrder, dynamic_programming, lbfgs,
    sobolev_descent,
};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Method {
    Sobolev,
    Lbfgs(Coordinates),
    Dynamic(SecondOrder),
}

const METHODS: [Method; 5] = [
    Method::Sobolev,
    Method::Lbfgs(Coordinates::Points),
    Method::Lbfgs(Coordinates::Sobolev),
    Method::Dynamic(SecondOrder::Full),
    Method::Dynamic(SecondOrder::GaussNewton),
];

impl Method {
    fn run<const D: usize>(
        self,
        metric: &dyn Batches<D>,
        rule: Rule,
        start: &PointSequence<D>,
        limits: &Limits,
        watcher: &mut Watcher<'_, D>,
    ) -> Result<Descended<D>, DescentError> {
        let start = start.clone();
        let mut watch = |iterate: &Iterate<'_, D>| watcher(iterate);
        let watch = &mut watch;
        match self {
            Self::Sobolev => sobolev_descent(metric, rule, start, limits, watch),
            Self::Lbfgs(coordinates) => lbfgs(metric, rule, start, coordinates, limits, watch),
            Self::Dynamic(form) => dynamic_programming(metric, rule, start, form, limits, watch),
        }
    }
}

macro_rules! gallery_cases {
    ($($name:ident: $group:literal, $metric:expr, dimension $d:literal, in $domain:expr,
        exact $exact:expr $(, with $distances:ident)?;)*) => {$(
        #[test]
        fn $name() {
            let [lower, upper]: [[f64; $d]; 2] = $domain;
            // Off the diagonal, so that no symmetry of the metric makes a saddle of the way.
            let at = |t: f64, off: f64| {
                SVector::<f64, $d>::from_fn(|i, _| {
                    let t = if i % 2 == 0 { t } else { off };
                    lower[i] + (upper[i] - lower[i]) * t
                })
            };
            reach_the_minimum(&$metric.expect("a metric"), at(0.23, 0.41), at(0.71, 0.68));
        }
    )*};
}

/// Every method reaches the minimum on every metric of the gallery, by every rule.
mod gallery_cases {
    use super::*;

    for_each_sample!(gallery_cases);
}

const N: usize = 40;

fn reach_the_minimum<M: Metric<D>, const D: usize>(
    metric: &M,
    a: SVector<f64, D>,
    b: SVector<f64, D>,
) {
    reach_the_minimum_of(Rule::TRAPEZOIDAL, metric, a, b);
    reach_the_minimum_of(Rule::LEFT_ENDPOINT, metric, a, b);
    reach_the_minimum_of(Rule::TRUE_TRAPEZOID, metric, a, b);
}

fn reach_the_minimum_of<M: Metric<D>, const D: usize>(
    rule: Rule,
    metric: &M,
    a: SVector<f64, D>,
    b: SVector<f64, D>,
) {
    let start = PointSequence::straight(a, b, N).expect("finite");
    let ends = Ends::points(a, b).expect("finite");
    let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
    let newton = minimise(metric, &ends, rule, N, &only).expect("a metric");
    assert!(newton.is_local_minimum());
    let prepared = Prepared::new(metric);
    for method in METHODS {
        let found = method.run(&prepared, rule, &start, &Limits::default(), &mut go_on);
        let found = found.expect("a metric");
        let error = found.energy / newton.energy - 1.0;
        // The excess of the energy is about the square of the residual, 1e-12.
        assert!(error.abs() <= 1e-10, "{rule}, {method:?}: {error:e}, {:?}", found.ended);
        let residual = found.residual;
        assert_eq!(found.ended, Ended::Stationary, "{rule}, {method:?}: {residual:e}");
        assert!(residual <= found.residual_floor.max(1e-6));
        assert_eq!(found.energy, found.sequence_energy(rule, metric), "{method:?}");
    }
}

trait Reevaluated<const D: usize> {
    fn sequence_energy<M: Metric<D>>(&self, rule: Rule, metric: &M) -> f64;
}

impl<const D: usize> Reevaluated<D> for Descended<D> {
    /// Returns the energy that the result claims if the energy of its points is that, up to the
    /// rounding of some 40 terms in another order.
    fn sequence_energy<M: Metric<D>>(&self, rule: Rule, metric: &M) -> f64 {
        let energy = rule.energy(metric, &self.sequence);
        if (energy - self.energy).abs() <= 1e-13 * energy { self.energy } else { energy }
    }
}

fn go_on<const D: usize>(_: &Iterate<'_, D>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn bump() -> Bump {
    Bump::new(4.0, 0.5).expect("a width")
}

/// Over the top of a bump the straight line is stationary up to rounding: every descent ends there,
/// and calls it stationary. The structured method sees the curvature, and leaves.
#[test]
fn descents_end_at_a_saddle_that_the_structured_method_leaves() {
    let (a, b) = (SVector::from([-1.5, 0.0]), SVector::from([1.5, 0.0]));
    let start = PointSequence::straight(a, b, N).expect("finite");
    let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
    let ends = Ends::points(a, b).expect("finite");
    let newton = minimise(&bump(), &ends, Rule::TRAPEZOIDAL, N, &only).expect("a metric");
    assert_eq!(newton.curvature, Curvature::PositiveDefinite);
    let metric = Prepared::new(bump());
    for method in METHODS {
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &start, &Limits::default(), &mut go_on);
        let found = found.expect("a metric");
        assert_eq!(found.ended, Ended::Stationary, "{method:?}");
        // The way over the top has more than twice the energy, 64 instead of 22.
        assert!(found.energy > 2.0 * newton.energy, "{method:?}: {}", found.energy);
        assert!(found.sequence.points().iter().all(|x| x[1] == 0.0), "{method:?}");
    }
}

/// Sixteen times as many chords: the condition number in the points is 256 times as large, and the
/// number of steps of L-BFGS grows with its root.
#[test]
fn sobolev_norms_make_the_number_of_steps_independent_of_n() {
    let metric = Prepared::new(
        SoftObstacles::<2>::new(vec![
            Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 },
            Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 },
        ])
        .expect("widths"),
    );
    let steps = |method: Method, n: usize| {
        let start = PointSequence::straight([-1.6, -0.5], [1.3, 1.1], n).expect("finite");
        let limits = Limits { tolerance: 1e-5, ..Limits::default() };
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &start, &limits, &mut go_on);
        let found = found.expect("a metric");
        assert_eq!(found.ended, Ended::Stationary, "{method:?}, N = {n}");
        found.iterations as f64
    };
    for method in METHODS {
        let growth = steps(method, 320) / steps(method, 20);
        if method == Method::Lbfgs(Coordinates::Points) {
            assert!(growth >= 4.0, "{method:?}: {growth}");
        } else {
            assert!(growth <= 2.0, "{method:?}: {growth}");
        }
    }
}

/// The last control leads to the end, so that the Riccati recursion solves the Newton system.
#[test]
fn a_step_of_full_dynamic_programming_is_a_newton_step() {
    let metric = Prepared::new(Valleys);
    let at = |k: usize| {
        let t = k as f64 / 12.0;
        SVector::from([4.0 * t, t + 0.05 * (7.0 * t).sin()])
    };
    let start = PointSequence::new((0..=12).map(at).collect()).expect("finite");
    let ends = [*start.first(), *start.last()].map(|x| tautline::Point::new(x).expect("finite"));
    let newton = newton_step(
        &mut Workspace::default(),
        &metric,
        [&ends[0], &ends[1]],
        Rule::TRAPEZOIDAL,
        &start,
    )
    .expect("definite");
    let mut second = None;
    let method = Method::Dynamic(SecondOrder::Full);
    let found =
        method.run(&metric, Rule::TRAPEZOIDAL, &start, &Limits::default(), &mut |iterate| {
            if iterate.iteration == 1 {
                second = Some(iterate.sequence.clone());
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
    assert_eq!(found.expect("a metric").ended, Ended::Interrupted);
    let second = second.expect("a step");
    for ((x, y), step) in start.points().iter().zip(second.points()).zip(&newton.step) {
        // The Newton step shifts the Hessian by a margin of 1e-8 of a regulariser with eigenvalues
        // like those of the Hessian.
        assert!((x + step - y).amax() <= 1e-6 * newton.step[6].amax().max(0.01));
    }
}

/// Nothing is lost when a search is ended: the result is the iterate that was shown last.
#[test]
fn a_descent_is_ended_at_any_iterate_and_keeps_it() {
    let metric = Prepared::new(bump());
    let start = PointSequence::straight([-1.5, 0.05], [1.5, -0.1], N).expect("finite");
    for method in METHODS {
        for end in [0, 1, 3] {
            let mut shown = None;
            let found =
                method.run(&metric, Rule::TRAPEZOIDAL, &start, &Limits::default(), &mut |it| {
                    shown = Some((it.energy, it.residual, it.sequence.clone()));
                    if it.iteration == end {
                        ControlFlow::Break(())
                    } else {
                        ControlFlow::Continue(())
                    }
                });
            let found = found.expect("a metric");
            assert_eq!((found.ended, found.iterations), (Ended::Interrupted, end), "{method:?}");
            assert_eq!(shown, Some((found.energy, found.residual, found.sequence)), "{method:?}");
        }
        let limits = Limits { iterations: 2, ..Limits::default() };
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &start, &limits, &mut go_on);
        let found = found.expect("a metric");
        assert_eq!((found.ended, found.iterations), (Ended::IterationLimit, 2), "{method:?}");
    }
}

/// A clock that takes a tenth of a millisecond for each iterate, and a limit of one millisecond.
#[test]
fn a_trace_ends_a_descent_after_a_millisecond() {
    let metric = Prepared::new(bump());
    let start = PointSequence::straight([-1.5, 0.05], [1.5, -0.1], 200).expect("finite");
    let limits = Limits { tolerance: 0.0, ..Limits::default() };
    for method in [Method::Sobolev, Method::Lbfgs(Coordinates::Points)] {
        let mut ticks = 0.0;
        let mut clock = || {
            ticks += 1e-4;
            ticks
        };
        let mut trace = Trace::with_limit(&mut clock, 0.00095);
        let found =
            method.run(&metric, Rule::TRAPEZOIDAL, &start, &limits, &mut |it| trace.record(it));
        let found = found.expect("a metric");
        assert_eq!((found.ended, trace.entries().len()), (Ended::Interrupted, 10), "{method:?}");
        let energies: Vec<_> = trace.entries().iter().map(|entry| entry.energy).collect();
        assert!(energies.windows(2).all(|pair| pair[1] < pair[0]), "{method:?}: {energies:?}");
        assert_eq!(trace.best(), Some((found.energy, &found.sequence)));
    }
}

/// The matrix `x₁ I`, which is a metric only to the right of 0.
struct ToTheRight;

impl Metric<2> for ToTheRight {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(x[0])
    }
}

#[test]
fn a_start_without_a_metric_or_an_energy_is_an_error() {
    let metric = Prepared::new(ToTheRight);
    let across = PointSequence::straight([-1.0, 0.0], [2.0, 0.0], 8).expect("finite");
    let far = PointSequence::straight([1e150, 0.0], [1e150, 1e150], 8).expect("finite");
    let fine = PointSequence::straight([1.0, 0.0], [2.0, 0.0], 8).expect("finite");
    let nan = Limits { tolerance: f64::NAN, ..Limits::default() };
    for method in METHODS {
        let run = |start, limits: &Limits| {
            method
                .run(&metric, Rule::TRAPEZOIDAL, start, limits, &mut go_on)
                .map(|found| found.ended)
        };
        let limits = Limits::default();
        assert!(matches!(run(&across, &limits), Err(DescentError::Metric(_))), "{method:?}");
        assert!(matches!(run(&far, &limits), Err(DescentError::Energy { .. })), "{method:?}");
        assert!(matches!(run(&fine, &nan), Err(DescentError::Tolerance { .. })), "{method:?}");
        assert_eq!(run(&fine, &limits), Ok(Ended::Stationary), "{method:?}");
    }
}

/// The metric `(1 + 10 (x₁ − 0.02)²) I` to the right of 0 alone: the first steps of all methods lead
/// beyond that edge.
struct BesideAnEdge;

impl Metric<2> for BesideAnEdge {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let cost = (x[0] - 0.02).sqr() * 10.0 + 1.0 + x[0].sqrt() * 0.0;
        SMatrix::from_diagonal_element(cost)
    }
}

/// The matrix `diag(e^{x₂}, x₂)`, a metric above 0 alone, where it has positive energies below it.
struct Above;

impl Metric<2> for Above {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let zero = S::constant(0.0);
        SMatrix::from([[x[1].exp(), zero], [zero, x[1]]])
    }
}

#[test]
fn descents_turn_back_where_there_is_no_metric() {
    let start = PointSequence::straight([1.0, 0.0], [1.0, 3.0], N).expect("finite");
    let ends = Ends::points(*start.first(), *start.last()).expect("finite");
    let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
    let newton = minimise(&BesideAnEdge, &ends, Rule::TRAPEZOIDAL, N, &only).expect("a metric");
    let metric = Prepared::new(BesideAnEdge);
    for method in METHODS {
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &start, &Limits::default(), &mut go_on);
        let found = found.expect("a metric");
        assert_eq!(found.ended, Ended::Stationary, "{method:?}");
        let error = found.energy / newton.energy - 1.0;
        assert!(error.abs() <= 1e-10, "{method:?}: {error:e}");
    }
    // Here the energy has no minimum above 0: what is returned has a metric all the same.
    let start = PointSequence::straight([0.0, 0.1], [4.0, 0.1], 2).expect("finite");
    let metric = Prepared::new(Above);
    for method in METHODS {
        let limits = Limits { iterations: 300, ..Limits::default() };
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &start, &limits, &mut go_on);
        let found = found.expect("a metric");
        assert!(found.sequence.chords().all(|(x, d)| (x + d * 0.5)[1] > 0.0), "{method:?}");
        assert!(found.energy > 0.0 && found.ended != Ended::Stationary, "{method:?}");
    }
}

/// A sequence is evaluated at the start, and once or twice in each step of the descents of ours: as a
/// trial, with its gradient, and for dynamic programming with its Hessian.
#[test]
fn evaluations_are_counted() {
    let flat = Constant::<2>::new(SMatrix::identity()).expect("definite");
    let metric = Prepared::new(flat);
    let bent = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]].map(SVector::from);
    let bent = PointSequence::new(bent.to_vec()).expect("finite");
    // The energy is quadratic, and the first step of both leads to its minimum.
    for (method, evaluations) in [
        (Method::Sobolev, 3),
        (Method::Dynamic(SecondOrder::Full), 4),
        (Method::Dynamic(SecondOrder::GaussNewton), 4),
    ] {
        let found = method.run(&metric, Rule::TRAPEZOIDAL, &bent, &Limits::default(), &mut go_on);
        let found = found.expect("a metric");
        assert_eq!((found.iterations, found.evaluations), (1, evaluations), "{method:?}");
    }
}

/// One chord has no inner point, and two chords have one.
#[test]
fn the_smallest_grids_have_a_minimum_too() {
    let metric = Prepared::new(Valleys);
    for n in [1, 2, 3] {
        let start = PointSequence::straight([0.3, 0.0], [2.0, 1.0], n).expect("finite");
        let ends = Ends::points(*start.first(), *start.last()).expect("finite");
        let only = Options { starts: Starts::Only(vec![start.clone()]), ..Options::default() };
        let newton = minimise(&Valleys, &ends, Rule::TRAPEZOIDAL, n, &only).expect("a metric");
        for method in METHODS {
            let found =
                method.run(&metric, Rule::TRAPEZOIDAL, &start, &Limits::default(), &mut go_on);
            let found = found.expect("a metric");
            assert_eq!(found.ended, Ended::Stationary, "{method:?}, N = {n}");
            let error = found.energy / newton.energy - 1.0;
            assert!(error.abs() <= 1e-10, "{method:?}, N = {n}: {error:e}");
        }
    }
}
