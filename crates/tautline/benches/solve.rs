//! What a solve costs beside one pass over the points that evaluates energy and gradient.
//!
//! Expect both to grow like `N`, and a solve of `N = 10⁵` in the plane to cost some ten passes:
//! on each grid one or two Newton steps, each a pass with second derivatives and a
//! factorisation.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use tautline::{
    Bounded, Ends, Problem, Trapezoidal,
    gallery::{Bump, Valleys},
};
use tautline_discretizations::energy_gradient;

fn compare<M: Bounded<2>>(c: &mut Criterion, name: &str, metric: M, ends: Ends<2>) {
    let problem = Problem::new(metric, ends);
    let mut group = c.benchmark_group(name);
    group.sample_size(10);
    for n in [1_000, 10_000, 100_000] {
        let line = problem.solve(Trapezoidal, n).expect("a metric on all of the plane");
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::new("gradient", n), &line, |b, line| {
            b.iter(|| energy_gradient(Trapezoidal, problem.metric(), black_box(line.sequence())));
        });
        group.bench_with_input(BenchmarkId::new("solve", n), &n, |b, &n| {
            b.iter(|| problem.solve(Trapezoidal, black_box(n)));
        });
    }
    group.finish();
}

fn solve(c: &mut Criterion) {
    let across = Ends::points([0.0, 0.0], [4.0 * std::f64::consts::PI, 0.0]).expect("finite");
    compare(c, "valleys", Valleys, across);
    let round = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    compare(c, "bump", Bump::new(4.0, 0.5).expect("positive"), round);
}

criterion_group!(benches, solve);
criterion_main!(benches);
