//! Tests small grids: they do not cost more than finer ones, and a few of them suffice to
//! extrapolate `d²`.

use std::{
    f64::consts::PI,
    sync::atomic::{AtomicUsize, Ordering},
};

use tautline_discretizations::Rule;
use tautline_formula::{AnyBatches, Batches, Kind, Layout, Prepared, Registers};
use tautline_metrics::{
    Metric,
    gallery::{CoupledCosines, Hill, Ramp, Separable, SineProjections, Sphere, Valleys},
};
use tautline_optimizers::{Options, Starts, Workspace, extrapolate, minimise, minimise_by_batches};
use tautline_sets::{Ends, FiniteSet};

use crate::setup::{
    ball, between, bump, euclidean, from_to, half_space, point, sequence, straight,
};

/// A metric that counts the numbers it computes. A value counts as one, a value with derivatives as
/// a dozen.
struct Counted<M, const D: usize> {
    metric: Prepared<M, D>,
    numbers: AtomicUsize,
}

impl<M: Metric<D>, const D: usize> Batches<D> for Counted<M, D> {}

impl<M: Metric<D>, const D: usize> AnyBatches for Counted<M, D> {
    fn dimension(&self) -> usize {
        D
    }
    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.numbers.fetch_add(1, Ordering::Relaxed);
        self.metric.gram_into(x, gram);
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

/// Returns the work of a solve from all starts. It runs on one thread, so that the work is
/// reproducible.
fn work<M: Metric<D>, const D: usize>(metric: &M, ends: &Ends<D>, rule: Rule, n: usize) -> usize {
    let counted = Counted { metric: Prepared::new(metric), numbers: AtomicUsize::new(0) };
    let options = Options { threads: 1, ..Options::default() };
    let memory = &mut Workspace::default();
    minimise_by_batches(memory, &counted, ends, rule, n, &options).expect("a metric");
    counted.numbers.into_inner()
}

/// Runs a check on the six problems on which solvers are compared, and on some problems in one
/// dimension, where the starts are a large part of the work.
#[track_caller]
fn on_each_problem(each: &impl Each) {
    let bump = bump();
    each.problem("P1", &Valleys, &from_to([0.0, 0.0], [4.0 * PI, 0.0]));
    each.problem("P2", &bump, &from_to([-1.5, 0.05], [1.5, -0.1]));
    each.problem("P3", &CoupledCosines, &from_to([0.0; 3], [3.0, 2.0, -2.0]));
    let sets = between(ball([-2.0, 0.0], 0.5), half_space([1.0, 0.0], 2.0));
    each.problem("P4", &bump, &sets);
    each.problem("P5", &SineProjections::benchmark(), &from_to([0.0; 8], [1.0; 8]));
    each.problem("P6", &Sphere, &from_to([-0.8, 0.3], [1.1, 0.6]));
    let waves = Separable::new([0.7], [1.3]).expect("below one");
    each.problem("waves", &waves, &from_to([-2.0], [2.5]));
    each.problem("flat", &euclidean::<1>(), &from_to([0.0], [1.0]));
    let hill = Hill::new(1.0, 0.8).expect("a width");
    let several = FiniteSet::new([[2.0], [2.5], [-2.2]]).expect("finite");
    each.problem("hill", &hill, &between(ball([0.2], 0.1), several));
}

/// A check of a problem in any dimension.
trait Each {
    fn problem<M: Metric<D>, const D: usize>(&self, name: &str, metric: &M, ends: &Ends<D>);
}

struct Cheap;

impl Each for Cheap {
    #[track_caller]
    fn problem<M: Metric<D>, const D: usize>(&self, name: &str, metric: &M, ends: &Ends<D>) {
        let assert_cheap = |of: &dyn Fn(usize) -> usize| {
            let fine = of(512);
            // Up to 32 chords the solve is direct, beyond that it goes over one coarser grid.
            for n in [1, 2, 3, 4, 5, 6, 8, 11, 16, 23, 32, 33, 34, 40, 48, 56, 63, 64] {
                let small = of(n);
                assert!(5 * small <= 6 * fine, "{name}, N = {n}: {small} and {fine} for N = 512");
            }
        };
        assert_cheap(&|n| work(metric, ends, Rule::TRAPEZOIDAL, n));
        assert_cheap(&|n| work(metric, ends, Rule::LEFT_ENDPOINT, n));
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
        let solve = |n| minimise(metric, ends, Rule::TRAPEZOIDAL, n, &Options::default());
        let estimate = |n| {
            let minimum = solve(n).expect("a metric");
            assert_eq!(minimum.levels.last().map(|level| level.n), Some(n));
            (minimum.energy, extrapolate(&minimum.levels, Rule::TRAPEZOIDAL.error_exponent()))
        };
        let (_, Some(fine)) = estimate(4096) else { panic!("{name}: no estimate") };
        for n in [33, 34, 40, 48, 63] {
            assert!(estimate(n).1.is_some(), "{name}, N = {n}: no estimate");
        }
        let (energy, Some(small)) = estimate(64) else { panic!("{name}: no estimate for N = 64") };
        // The estimate is better than the energy itself, even if a coarse grid leaps. Flat metrics
        // only have rounding.
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

/// A given start is used on the finest grid, since it has bends that a grid of 32 chords cannot
/// follow. With given starts alone, the search finds their minimiser.
#[test]
fn a_given_start_is_used_in_detail() {
    let waves = Separable::new([0.7], [12.0]).expect("below one");
    let ends = from_to([-2.0], [2.5]);
    let solve = |starts| {
        let options = Options { starts, ..Options::default() };
        minimise(&waves, &ends, Rule::TRAPEZOIDAL, 64, &options).expect("a metric")
    };
    let straight = straight([-2.0], [2.5], 64);
    let only = solve(Starts::Only(vec![straight.clone()]));
    assert_eq!(only.levels.iter().map(|level| level.n).collect::<Vec<_>>(), [64]);
    // An additional start is used as it is, so the energy of the result is not higher.
    let also = solve(Starts::Also(vec![only.sequence.clone()]));
    assert!(also.energy <= only.energy * (1.0 + 1e-12), "{} {}", also.energy, only.energy);
}

/// Up a ramp, the left-endpoint rule saves energy by a leap to the end from the foot, where it
/// evaluates the metric. With half as many chords the leap is longer, and need not lead to the
/// lowest minimiser.
#[test]
fn leaps_are_found_on_a_grid_that_is_not_the_coarsest() {
    let ramp = Ramp::new(0.877, 2.11).expect("below one");
    let (from, to) = ([-2.6], [1.65]);
    let ends = from_to(from, to);
    // The result is the same if a point far away precedes the end.
    let members = FiniteSet::new([[-60.0], to]).expect("finite");
    let pieces = between(point(from), members);
    let energy_between = |ends: &Ends<1>, n: usize, starts| {
        let options = Options { starts, ..Options::default() };
        minimise(&ramp, ends, Rule::LEFT_ENDPOINT, n, &options).expect("a metric").energy
    };
    let energy = |n: usize, starts| energy_between(&ends, n, starts);
    for n in [33, 40, 48, 56, 64] {
        let leap_from = |foot: f64| {
            let walk = straight(from, [foot], n - 1);
            let points = walk.into_points().into_iter().chain([to.into()]).collect();
            sequence(points)
        };
        let feet = (1..24).map(|k| -0.1 * f64::from(k));
        let leaps = feet.map(|foot| energy(n, Starts::Only(vec![leap_from(foot)])));
        let best = leaps.fold(f64::INFINITY, f64::min);
        for ends in [&ends, &pieces] {
            let found = energy_between(ends, n, Starts::Automatic);
            assert!(found <= best * (1.0 + 1e-9), "N = {n}: {found} above {best}");
        }
    }
}
