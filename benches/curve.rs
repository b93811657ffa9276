//! The cost of enclosing the energy and the length of a polygon of `N = 10⁴` chords, compared with
//! the same computation in floats. Expect 2 to 8 µs per chord for both enclosures. This is 15 to 20
//! times the cost of both quadratures, and about 350 times the cost of one discrete energy.
//! Enclosing the discrete energy takes 30 to 50 times as long as computing it. The kernel matters
//! little, since most of the time is spent in the four operations.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::vector;
use tautline_certify::Polygon;
use tautline_discretizations::{Interpolation, PointSequence, Rule};
use tautline_metrics::{
    Metric,
    gallery::{EggCrate, GaussianFisher, Valleys},
};
use tautline_scalar::Fast;

const N: usize = 10_000;

fn measure(c: &mut Criterion, name: &str, metric: &impl Metric<2>) {
    let at = |k: usize| {
        let t = k as f64 / N as f64;
        vector![3.0 * (2.0 * t - 1.0), 2.0 * (3.0 * t).sin()]
    };
    let sequence = PointSequence::new((0..=N).map(at).collect()).expect("finite");
    let mut group = c.benchmark_group(name);
    // The throughput is given per chord.
    group.throughput(Throughput::Elements(N as u64)).sample_size(20);
    let polygon = Polygon::new(&sequence);
    group.bench_function("enclosures", |b| {
        b.iter(|| polygon.energy_and_length(black_box(metric)));
    });
    let fast = polygon.with_kernel::<Fast>();
    group.bench_function("enclosures, fast kernel", |b| {
        b.iter(|| fast.energy_and_length(black_box(metric)));
    });
    group.bench_function("enclosure of the discrete energy", |b| {
        b.iter(|| polygon.discrete_energy(Rule::TRAPEZOIDAL, black_box(metric)));
    });
    let curve = Interpolation::new(&sequence);
    group.bench_function("quadratures", |b| {
        b.iter(|| (curve.energy(black_box(metric)), curve.length(black_box(metric))));
    });
    group.bench_function("discrete energy", |b| {
        b.iter(|| Rule::TRAPEZOIDAL.energy(black_box(metric), &sequence));
    });
    group.finish();
}

fn curve(c: &mut Criterion) {
    measure(c, "valleys", &Valleys);
    measure(c, "Fisher", &GaussianFisher);
    measure(c, "egg crate", &EggCrate::new(0.5, 2.0).expect("positive"));
}

criterion_group!(benches, curve);
criterion_main!(benches);
