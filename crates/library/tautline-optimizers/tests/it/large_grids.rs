//! Tests grids on which the points that are extrapolated from coarser grids are a minimiser up to
//! rounding, so that they are only evaluated. All claims must hold nevertheless. Also tests the way
//! there, over coarse grids that resolve little of the metric.

use std::{collections::HashSet, f64::consts::PI, sync::Mutex, thread};

use nalgebra::{SMatrix, SVector, vector};
use tautline_discretizations::{Rule, energy_gradient};
use tautline_formula::{AnyBatches, Batches, Kind, Layout, Plain, Prepared, Registers};
use tautline_metrics::{
    Metric, MetricError, Scalar,
    gallery::{Bump, CoupledCosines, Separable, SineProjection, SineProjections, Sphere, Valleys},
};
use tautline_optimizers::{
    Minimum, Options, SolveError, Workspace, minimise, minimise_by_batches, newton_step,
};

use crate::setup::{between, bump, from_to, half_space, lowest, only, point, straight};

fn from_the_line<const D: usize>(
    metric: &impl Metric<D>,
    rule: Rule,
    [a, b]: [[f64; D]; 2],
    n: usize,
) -> Result<Minimum<D>, SolveError> {
    on_threads(1, &Prepared::new(metric), rule, [a, b], n)
}

fn on_threads<const D: usize>(
    threads: usize,
    metric: &dyn Batches<D>,
    rule: Rule,
    [a, b]: [[f64; D]; 2],
    n: usize,
) -> Result<Minimum<D>, SolveError> {
    let options = Options { threads, ..only(straight(a, b, 1)) };
    minimise_by_batches(&mut Workspace::default(), metric, &from_to(a, b), rule, n, &options)
}

/// Compares the energy, the residual and the decrement with those computed from the points.
#[track_caller]
fn assert_true<const D: usize>(metric: &impl Metric<D>, rule: Rule, line: [[f64; D]; 2], n: usize) {
    let minimum = from_the_line(metric, rule, line, n).expect("a metric");
    assert!(minimum.is_local_minimum() && minimum.levels.len() > 2);
    let (energy, gradient) = energy_gradient(rule, metric, &minimum.sequence);
    // Both sums are compensated, and a term is known to a dozen roundings.
    assert!((minimum.energy / energy - 1.0).abs() < 3e-15, "{} {energy}", minimum.energy);
    // ρₙ = (N/2) ∂E/∂xₙ at the inner points, relative to (c E)^{1/2}. If the ends are points, the
    // residual has no other part.
    let squares = gradient[1..n].iter().map(|g| g.norm_squared());
    let root = (squares.sum::<f64>() / n as f64).sqrt();
    let trace = |(x, d): (&SVector<f64, D>, SVector<f64, D>)| {
        let at = |node: &tautline_discretizations::Node| {
            node.weight * metric.gram::<f64>(&(x + d * node.fraction)).trace()
        };
        rule.nodes().iter().map(at).sum::<f64>()
    };
    let mean = minimum.sequence.chords().map(trace).sum::<f64>() / (n * D) as f64;
    let residual = 0.5 * n as f64 * root / (mean * energy).sqrt();
    // The gradient is rounding, so it differs by a few per cent if it is summed in another order.
    assert!((minimum.residual / residual - 1.0).abs() < 0.3, "{:e} {residual:e}", minimum.residual);
    // Only rounding remains, whether a step was taken or not.
    let floor = minimum.residual_floor;
    assert!(minimum.residual <= 2.0 * floor, "N = {n}: {:e} {floor:e}", minimum.residual);
    let [a, b] = line.map(point);
    let mut workspace = Workspace::default();
    let batches = Prepared::new(metric);
    let step = newton_step(&mut workspace, &batches, [&a, &b], rule, &minimum.sequence);
    let decrement = step.expect("positive definite").decrement / energy;
    // Both decrements are of the order of rounding, and negligible.
    let range = 0.3 * decrement..=3.0 * decrement + 1e-28;
    assert!(range.contains(&minimum.decrement), "{:e} {decrement:e}", minimum.decrement);
    assert!(minimum.decrement <= 1e-18, "{:e}", minimum.decrement);
}

#[test]
fn the_claims_of_a_minimum_hold_on_every_grid() {
    let bump = bump();
    for n in [3_000, 10_000, 40_000, 70_000] {
        assert_true(&Valleys, Rule::TRAPEZOIDAL, [[0.0, 0.0], [4.0 * PI, 0.0]], n);
        assert_true(&bump, Rule::TRAPEZOIDAL, [[-1.5, 0.05], [1.5, -0.1]], n);
        assert_true(&bump, Rule::LEFT_ENDPOINT, [[-1.5, 0.05], [1.5, -0.1]], n);
        assert_true(&CoupledCosines, Rule::TRAPEZOIDAL, [[0.0; 3], [3.0, 2.0, -2.0]], n);
        assert_true(&Sphere, Rule::TRAPEZOIDAL, [[-0.8, 0.3], [1.1, 0.6]], n);
    }
}

/// A bump whose Gram matrix is not symmetric within about 10⁻⁵ of `x₁ = 0.1001`.
struct Slit(Bump);

impl Metric<2> for Slit {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let mut h: SMatrix<S, 2, 2> = self.0.gram(x);
        h[(1, 0)] += (-((x[0] - 0.1001) * 1e5).sqr()).exp() * 1e-3;
        h
    }
}

/// Coarser grids step over the slit, and a Newton step reads only the correct triangle of the
/// matrix.
#[test]
fn a_defect_at_a_node_is_found_on_the_finest_grid() {
    let slit = Slit(bump());
    let line = [[-1.5, 0.05], [1.5, -0.1]];
    for n in [2_500, 5_000] {
        let coarse =
            from_the_line(&slit, Rule::TRAPEZOIDAL, line, n).expect("a metric at the nodes");
        assert!(coarse.is_local_minimum());
    }
    let fine = from_the_line(&slit, Rule::TRAPEZOIDAL, line, 80_000);
    let refused = matches!(fine, Err(SolveError::Metric(MetricError::NotSymmetric { .. })));
    assert!(refused, "{:?}", fine.map(|minimum| minimum.residual));
}

/// Nine chords leap over both ridges of this metric, with energies of 9.5 and 11. On finer grids
/// these minima rise to 87 and 140, while the lowest minimum has energy 33.15.
#[test]
fn the_starts_are_tried_again_after_a_leap() {
    let ridges = Separable::new(vector![0.788, 0.0, 0.0], vector![1.663, 1.0, 1.0]);
    let ridges = ridges.expect("below one");
    let line = [[-2.866, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let ends = from_to(line[0], line[1]);
    let automatic = lowest(&ridges, &ends, Rule::TRAPEZOIDAL, 129);
    let alone = from_the_line(&ridges, Rule::TRAPEZOIDAL, line, 129).expect("a metric");
    for minimum in [automatic, alone] {
        assert!((minimum.energy - 33.15).abs() < 0.1, "{:?}", minimum.levels);
        assert!(minimum.is_local_minimum());
    }
}

/// A metric that records the threads that evaluate it.
struct Asked<'m, const D: usize>(&'m dyn Batches<D>, Mutex<HashSet<thread::ThreadId>>);

impl<const D: usize> Batches<D> for Asked<'_, D> {}

impl<const D: usize> AnyBatches for Asked<'_, D> {
    fn dimension(&self) -> usize {
        D
    }
    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.0.gram_into(x, gram);
    }
    fn layout(&self, kind: Kind) -> &Layout {
        self.0.layout(kind)
    }
    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.0.registers(kind, unit, units)
    }
    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        self.1.lock().expect("nobody panics").insert(thread::current().id());
        self.0.evaluate(kind, registers);
    }
}

#[track_caller]
fn assert_same_on_two_threads<const D: usize>(
    metric: impl Metric<D> + Copy,
    rule: Rule,
    line: [[f64; D]; 2],
    n: usize,
) {
    let (prepared, plain) = (Prepared::new(metric), Plain::new(metric));
    for way in [&prepared as &dyn Batches<D>, &plain] {
        assert_same_by(way, rule, line, n);
    }
}

/// Compares one thread with two for one of the ways to evaluate a metric.
#[track_caller]
fn assert_same_by<const D: usize>(
    metric: &dyn Batches<D>,
    rule: Rule,
    line: [[f64; D]; 2],
    n: usize,
) {
    let [one, two] = [1, 2].map(|threads| {
        let asked = Asked(metric, Mutex::default());
        let minimum = on_threads(threads, &asked, rule, line, n).expect("a metric");
        let more = asked.1.lock().expect("nobody panics").len() > 1;
        assert_eq!(more, threads > 1 && has_two_processors());
        minimum
    });
    assert!(one == two, "{D} dimensions, N = {n}");
}

/// With a single processor, the tests below compare one thread with itself.
fn has_two_processors() -> bool {
    thread::available_parallelism().is_ok_and(|processors| processors.get() > 1)
}

/// The numbers of chords are even and odd.
#[test]
fn two_threads_find_the_same_bit_by_bit() {
    let five = projections::<5>();
    for n in [3_000, 3_001] {
        assert_same_on_two_threads(&five, Rule::TRAPEZOIDAL, [[0.0; 5], [1.0; 5]], n);
        assert_same_on_two_threads(&five, Rule::LEFT_ENDPOINT, [[0.0; 5], [1.0; 5]], n);
    }
    assert_same_on_two_threads(
        &projections::<4>(),
        Rule::TRAPEZOIDAL,
        [[0.0; 4], [1.0; 4]],
        30_001,
    );
}

/// The Gram matrix is not symmetric within about 10⁻⁵ of a hyperplane. The defect is in an entry
/// that has no effect along a line in `x₅ = 0`.
struct Torn<'a> {
    metric: &'a SineProjections<5>,
    at: f64,
}

impl Metric<5> for Torn<'_> {
    fn gram<S: Scalar>(&self, x: &SVector<S, 5>) -> SMatrix<S, 5, 5> {
        let mut h: SMatrix<S, 5, 5> = self.metric.gram(x);
        h[(1, 4)] += (-((x[0] - self.at) * 1e5).sqr()).exp() * 1e-6;
        h
    }
}

/// The defect is at a single node of the finest grid, near one end or the other.
#[test]
fn a_defect_at_a_node_is_found_on_either_side() {
    let term = |k: f64| SineProjection {
        wave_vector: vector![k.sin(), 1.0, 0.5 * k, k.cos(), 0.0],
        direction: vector![0.5 * k.cos(), 0.3, -0.2, 0.1 * k, 0.0],
    };
    let metric = SineProjections::new([1.0, 2.0, 3.0].map(term).to_vec()).expect("finite");
    let (line, n) = ([[0.0; 5], [1.0, 1.0, 1.0, 1.0, 0.0]], 3_000);
    let whole = from_the_line(&metric, Rule::TRAPEZOIDAL, line, n).expect("a metric");
    for k in [100, 2_900] {
        let (x, d) = whole.sequence.chord(k);
        let torn = Torn { metric: &metric, at: x[0] + 0.5 * d[0] };
        let coarse =
            from_the_line(&torn, Rule::TRAPEZOIDAL, line, 750).expect("a metric at the nodes");
        assert!(coarse.is_local_minimum());
        for threads in [1, 2] {
            let fine = on_threads(threads, &Prepared::new(&torn), Rule::TRAPEZOIDAL, line, n);
            let refused = matches!(fine, Err(SolveError::Metric(MetricError::NotSymmetric { .. })));
            assert!(refused, "{k}: {:?}", fine.map(|minimum| minimum.residual));
        }
    }
}

fn projections<const D: usize>() -> SineProjections<D> {
    let term = |k: f64| SineProjection {
        wave_vector: SVector::from_fn(|i, _| (0.7 * k + (i + 1) as f64).sin()),
        direction: SVector::from_fn(|i, _| 0.5 * (1.3 * k * (i + 1) as f64).cos()),
    };
    SineProjections::new([1.0, 2.0, 3.0].map(term).to_vec()).expect("finite")
}

/// `H = (2 − cos x₁)² (3 + cos x₂) I`, which is undefined for `|x₂ − c| < w`.
struct Band {
    c: f64,
    w: f64,
}

impl Metric<2> for Band {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let outside = ((x[1] - self.c).sqr() - self.w * self.w).sqrt() * 0.0 + 1.0;
        SMatrix::from_diagonal_element((-x[0].cos() + 2.0).sqr() * (x[1].cos() + 3.0) * outside)
    }
}

/// The left-endpoint rule does not evaluate the metric at the last point. If that point lies on a
/// wall, it is at a different place on every grid. The metric has to be checked there separately.
#[test]
fn a_last_point_without_a_metric_is_an_error_although_no_rule_reads_it() {
    let wall = half_space([1.0, 0.2], 2.0);
    let ends = between(point([0.0, 0.3]), wall);
    let options = Options::default();
    let solve = |c, w| minimise(&Band { c, w }, &ends, Rule::LEFT_ENDPOINT, 256, &options);
    let free = solve(1e3, 1e-7).expect("a metric");
    let [x, y] = [free.sequence.last()[0], free.sequence.last()[1]];
    assert!(free.is_local_minimum() && free.levels.len() > 2);
    match solve(y, 1e-7) {
        Err(SolveError::Metric(MetricError::NotFinite { point, .. })) => {
            assert!((point[0] - x).abs() < 1e-6 && (point[1] - y).abs() < 1e-6, "{point:?}");
        }
        other => panic!("{other:?}"),
    }
}
