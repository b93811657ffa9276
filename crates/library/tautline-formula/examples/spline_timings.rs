//! Times values, expansions and enclosures, and tells the memory they need.
//!
//! `cargo run --release -p tautline-formula --example spline_timings`

use std::{hint::black_box, time::Instant};

use tautline_chance::Random;
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

/// Prints the time of one call of `work`, in nanoseconds. The calls are in batches of a thousand, of
/// which the fastest counts, so that other work of the machine does not.
fn time(what: &str, mut work: impl FnMut(usize)) {
    let batch = |_| {
        let start = Instant::now();
        (0..1000).for_each(&mut work);
        start.elapsed().as_nanos() as f64 / 1000.0
    };
    let best = (0..50).map(batch).fold(f64::INFINITY, f64::min);
    println!("{what:52} {best:10.1} ns");
}

fn megabytes(spline: &Spline) -> f64 {
    spline.memory() as f64 / 1e6
}

/// Returns boxes of this width, with their lower corners anywhere in the array.
fn boxes<const E: usize>(n: usize, width: f64, random: &mut Random) -> Vec<[Interval; E]> {
    let mut side = || {
        let lo = random.between(0.0, n as f64 - 1.0 - width);
        Interval::new(lo, lo + width).expect("ordered")
    };
    (0..1000).map(|_| [(); E].map(|()| side())).collect()
}

fn times<const E: usize>(n: usize, orders: &[[u8; 3]]) {
    let mut random = Random(1);
    let noise: Vec<f64> = (0..n.pow(E as u32)).map(|_| random.between(1.0, 2.0)).collect();
    println!("\n{E} axes of {n} coefficients");
    let spline = Spline::new(&[n; E], noise).expect("finite");
    let points: Vec<[f64; E]> =
        (0..1000).map(|_| [(); E].map(|()| random.between(0.0, n as f64 - 1.0))).collect();
    time("value", |k| {
        black_box(spline.value(&points[k % 1000], [0; 3]));
    });
    time("value, gradient and Hessian", |k| {
        black_box(spline.expansion(&points[k % 1000]));
    });
    let boxes_of_1_percent = boxes::<E>(n, 0.01, &mut random);
    time("bounds on these over a box of width 0.01", |k| {
        black_box(spline.enclosures(&boxes_of_1_percent[k % 1000]));
    });
    println!("{:52} {:10.2} MB", "memory", megabytes(&spline));
    for &order in orders {
        let start = Instant::now();
        black_box(spline.range::<tautline_scalar::Rigorous>(order));
        let built = start.elapsed().as_secs_f64() * 1e3;
        println!("orders {order:?}: pyramid in {built:.1} ms, memory {:.2} MB", megabytes(&spline));
        for width in [0.0, 0.01, 1.0, 0.1 * n as f64, 0.5 * n as f64] {
            let boxes = boxes::<E>(n, width, &mut random);
            time(&format!("  enclosure over a box of width {width}"), |k| {
                black_box(spline.enclosure(&boxes[k % 1000], order));
            });
        }
    }
    let all = [Interval::REALS; E];
    time("  enclosure over all of space", |_| {
        black_box(spline.enclosure(&all, [0; 3]));
    });
}

/// In a bowl, the extremes of a window are at its border, so that a search of the pyramid must look
/// at most blocks there.
fn bowl(n: usize) {
    let numbers = (0..n * n).map(|k| {
        let [x, y] = [k / n, k % n].map(|k| (2 * k) as f64 / n as f64 - 1.0);
        x * x + y * y
    });
    let spline = Spline::new(&[n, n], numbers.collect()).expect("finite");
    println!("\na bowl");
    let mut random = Random(2);
    for width in [0.1 * n as f64, 0.5 * n as f64] {
        let boxes = boxes::<2>(n, width, &mut random);
        time(&format!("  enclosure over a box of width {width}"), |k| {
            black_box(spline.enclosure(&boxes[k % 1000], [0; 3]));
        });
    }
}

fn main() {
    times::<1>(512, &[[0; 3], [2, 0, 0]]);
    times::<2>(512, &[[0; 3], [1, 0, 0], [0, 1, 0], [2, 0, 0], [1, 1, 0], [0, 2, 0], [0, 3, 0]]);
    bowl(512);
    times::<3>(64, &[[0; 3], [1, 1, 0]]);
}
