//! The cost of operations on intervals, for both kernels, compared with the same operations on
//! `f64`.
//!
//! Each measurement is one pass over 1024 arguments, or pairs of arguments, in `[0.1, 3]`. The
//! intervals have the width `10⁻³`, as after some subdivision. Divide by 1024 for the time of one
//! operation.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use tautline_scalar::{Enclosure, Fast, Kernel, Rigorous, Scalar};

fn numbers() -> Vec<f64> {
    // Fractional parts of multiples of the golden ratio fill the range evenly.
    (1..=1024).map(|i| 0.1 + 2.9 * (f64::from(i) * 0.618_033_988_749_895).fract()).collect()
}

fn intervals<K: Kernel>() -> Vec<Enclosure<K>> {
    numbers().into_iter().map(|x| Enclosure::new(x, x + 1e-3).expect("ordered")).collect()
}

fn operations<S: Scalar>(c: &mut Criterion, name: &str, arguments: &[S]) {
    let mut group = c.benchmark_group(name);
    let mut pairs = |name: &str, f: fn(S, S) -> S| {
        group.bench_function(name, |b| {
            b.iter(|| {
                for pair in black_box(arguments).windows(2) {
                    black_box(f(pair[0], pair[1]));
                }
            });
        });
    };
    pairs("add", |x, y| x + y);
    pairs("mul", |x, y| x * y);
    pairs("div", |x, y| x / y);
    let mut one = |name: &str, f: fn(S) -> S| {
        group.bench_function(name, |b| {
            b.iter(|| {
                for &x in black_box(arguments) {
                    black_box(f(x));
                }
            });
        });
    };
    one("sqr", S::sqr);
    one("sqrt", S::sqrt);
    one("exp", S::exp);
    one("ln", S::ln);
    one("sin", S::sin);
    one("atan", S::atan);
    one("tanh", S::tanh);
    group.finish();
}

fn interval(c: &mut Criterion) {
    operations(c, "f64", &numbers());
    operations(c, "rigorous", &intervals::<Rigorous>());
    operations(c, "fast", &intervals::<Fast>());
}

criterion_group!(benches, interval);
criterion_main!(benches);
