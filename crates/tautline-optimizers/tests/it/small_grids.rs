//! Small grids: they cost no more than finer ones, and from a few of them `d²` is extrapolated.

use std::{
    f64::consts::PI,
    sync::atomic::{AtomicUsize, Ordering},
};

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{LeftEndpoint, PointSequence, Rule, Trapezoidal};
use tautline_formula::{Batches, Kind, Layout, Prepared, Registers};
use tautline_metrics::{
    Metric,
    gallery::{
        Bump, Constant, CoupledCosines, Hill, Ramp, Separable, SineProjections, Sphere, Valleys,
    },
};
use tautline_optimizers::{Options, Starts, Workspace, extrapolate, minimise, minimise_by_batches};
use tautline_sets::{Ball, Ends, FiniteSet, HalfSpace, Point};

/// A metric that counts the numbers for which it is asked: one for a value, a dozen for a value with its
/// derivatives.
struct Counted<M, const D: usize> {
    metric: Prepared<M, D>,
    numbers: AtomicUsize,
}

impl<M: Metric<D>, const D: usize> Batches<D> for Counted<M, D> {
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        self.numbers.fetch_add(1, Ordering::Relaxed);
        self.metric.gram(x)
    }
    fn layout(&self, kind: Kind) -> &Layout {
        self.metric.layout(kind)
    }
    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.metric.registers(kind, unit, units)
    }
    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        let numbers = match kind {
            Kind::Square | Kind::Checked => 1,
            Kind::Momentum => 1 + D,
            Kind::Contraction => 1 + D + D * (D + 1) / 2,
        };
        self.numbers.fetch_add(registers.count() * numbers, Ordering::Relaxed);
        self.metric.evaluate(kind, registers);
    }
}

/// The work of a solve from all starts, with one thread so that it is the same in each run.
fn work<M: Metric<D>, const D: usize>(
    metric: &M,
    ends: &Ends<D>,
    rule: impl Rule,
    n: usize,
) -> usize {
    let counted = Counted { metric: Prepared::new(metric), numbers: AtomicUsize::new(0) };
    let options = Options { threads: 1, ..Options::default() };
    let memory = &mut Workspace::default();
    minimise_by_batches(memory, &counted, ends, rule, n, &options).expect("a metric");
    counted.numbers.into_inner()
}

/// The six problems on which solvers are compared, and some on the line, where the way from all starts
/// is a large part of the whole.
#[track_caller]
fn on_each_problem(each: &impl Each) {
    let bump = Bump::new(4.0, 0.5).expect("positive");
    let points = |a: [f64; 2], b: [f64; 2]| Ends::points(a, b).expect("finite");
    each.problem("P1", &Valleys, &points([0.0, 0.0], [4.0 * PI, 0.0]));
    each.problem("P2", &bump, &points([-1.5, 0.05], [1.5, -0.1]));
    let space = Ends::points([0.0; 3], [3.0, 2.0, -2.0]).expect("finite");
    each.problem("P3", &CoupledCosines, &space);
    let ball = Ball::new([-2.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 2.0).expect("a normal");
    each.problem("P4", &bump, &Ends::new(ball, wall).expect("bounded"));
    let cube = Ends::points([0.0; 8], [1.0; 8]).expect("finite");
    each.problem("P5", &SineProjections::benchmark(), &cube);
    each.problem("P6", &Sphere, &points([-0.8, 0.3], [1.1, 0.6]));
    let line = |a: f64, b: f64| Ends::points([a], [b]).expect("finite");
    let waves = Separable::new([0.7], [1.3]).expect("below one");
    each.problem("waves", &waves, &line(-2.0, 2.5));
    let flat = Constant::<1>::new(SMatrix::identity()).expect("definite");
    each.problem("flat", &flat, &line(0.0, 1.0));
    let hill = Hill::new(1.0, 0.8).expect("a width");
    let several = FiniteSet::new([[2.0], [2.5], [-2.2]]).expect("finite");
    let interval = Ball::new([0.2], 0.1).expect("a radius");
    each.problem("hill", &hill, &Ends::new(interval, several).expect("bounded"));
}

/// What is done with each problem, whatever its dimension.
trait Each {
    fn problem<M: Metric<D>, const D: usize>(&self, name: &str, metric: &M, ends: &Ends<D>);
}

struct Cheap;

impl Each for Cheap {
    #[track_caller]
    fn problem<M: Metric<D>, const D: usize>(&self, name: &str, metric: &M, ends: &Ends<D>) {
        let assert_cheap = |of: &dyn Fn(usize) -> usize| {
            let fine = of(512);
            // All up to 32 are tried directly; then some with one grid before.
            for n in [1, 2, 3, 4, 5, 6, 8, 11, 16, 23, 32, 33, 34, 40, 48, 56, 63, 64] {
                let small = of(n);
                assert!(5 * small <= 6 * fine, "{name}, N = {n}: {small} and {fine} for N = 512");
            }
        };
        assert_cheap(&|n| work(metric, ends, Trapezoidal, n));
        assert_cheap(&|n| work(metric, ends, LeftEndpoint, n));
    }
}

#[test]
fn a_small_grid_takes_no_more_work_than_a_fine_one() {
    on_each_problem(&Cheap);
}

struct Extrapolated;

impl Each for Extrapolated {
    #[track_caller]
    fn problem<M: Metric<D>, const D: usize>(&self, name: &str, metric: &M, ends: &Ends<D>) {
        let solve = |n| minimise(metric, ends, Trapezoidal, n, &Options::default());
        let estimate = |n| {
            let minimum = solve(n).expect("a metric");
            assert_eq!(minimum.levels.last().map(|level| level.n), Some(n));
            (minimum.energy, extrapolate(&minimum.levels, Trapezoidal::ERROR_EXPONENT))
        };
        let (_, Some(fine)) = estimate(4096) else { panic!("{name}: no estimate") };
        for n in [33, 34, 40, 48, 63] {
            assert!(estimate(n).1.is_some(), "{name}, N = {n}: no estimate");
        }
        let (energy, Some(small)) = estimate(64) else { panic!("{name}: no estimate for N = 64") };
        // Better than the energy itself, even where a coarse grid leaps. Flat metrics have no error
        // but rounding.
        let (before, after) = ((energy - fine.value).abs(), (small.value - fine.value).abs());
        let rounding = 1e-13 * fine.value;
        assert!(after <= before + rounding, "{name}: {after:e} {before:e}");
        for n in [1, 2, 16, 32] {
            assert_eq!(estimate(n).1, None, "{name}, N = {n}: one grid only");
        }
    }
}

#[test]
fn two_grids_are_enough_for_an_estimate() {
    on_each_problem(&Extrapolated);
}

/// Of a start of one's own nothing is lost: between the bends of a line that a grid of 32 chords cannot
/// follow lies a minimiser of its own, and with one's own starts alone it is found.
#[test]
fn a_start_of_ones_own_is_begun_with_in_all_detail() {
    let waves = Separable::new([0.7], [12.0]).expect("below one");
    let ends = Ends::points([-2.0], [2.5]).expect("finite");
    let solve = |starts| {
        let options = Options { starts, ..Options::default() };
        minimise(&waves, &ends, Trapezoidal, 64, &options).expect("a metric")
    };
    let straight = PointSequence::straight([-2.0], [2.5], 64).expect("finite");
    let only = solve(Starts::Only(vec![straight.clone()]));
    assert_eq!(only.levels.iter().map(|level| level.n).collect::<Vec<_>>(), [64]);
    // What is given besides is tried as it is, and lost to nothing that costs more.
    let also = solve(Starts::Also(vec![only.sequence.clone()]));
    assert!(also.energy <= only.energy * (1.0 + 1e-12), "{} {}", also.energy, only.energy);
}

/// Up a ramp it pays the left-endpoint rule to leap from its foot, where the metric is read, to the end.
/// With half as many chords the leap is longer, and what it leads to need not be the lowest.
#[test]
fn leaps_are_found_on_a_grid_that_is_not_the_coarsest() {
    let ramp = Ramp::new(0.877, 2.11).expect("below one");
    let (from, to) = ([-2.6], [1.65]);
    let ends = Ends::points(from, to).expect("finite");
    // The same where a point far off comes before the end.
    let members = FiniteSet::new([[-60.0], to]).expect("finite");
    let pieces = Ends::new(Point::new(from).expect("finite"), members).expect("bounded");
    let energy_between = |ends: &Ends<1>, n: usize, starts| {
        let options = Options { starts, ..Options::default() };
        minimise(&ramp, ends, LeftEndpoint, n, &options).expect("a metric").energy
    };
    let energy = |n: usize, starts| energy_between(&ends, n, starts);
    for n in [33, 40, 48, 56, 64] {
        let leap_from = |foot: f64| {
            let walk = PointSequence::straight(from, [foot], n - 1).expect("finite");
            let points = walk.into_points().into_iter().chain([to.into()]).collect();
            PointSequence::new(points).expect("finite")
        };
        let feet = (1..24).map(|k| -0.1 * f64::from(k));
        let leaps = feet.map(|foot| energy(n, Starts::Only(vec![leap_from(foot)])));
        let best = leaps.fold(f64::INFINITY, f64::min);
        for ends in [&ends, &pieces] {
            let found = energy_between(ends, n, Starts::Automatic);
            assert!(found <= best * (1.0 + 1e-9), "N = {n}: {found}, and there is {best}");
        }
    }
}
