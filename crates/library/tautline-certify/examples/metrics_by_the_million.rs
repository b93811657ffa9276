//! Compares the metrics of the gallery and their derivatives over boxes with values in high
//! precision, a million times.
//!
//! The tests make a quarter of that; this takes ten seconds:
//! `cargo run --release -p tautline-certify --example metrics_by_the_million [COUNT] [SEED]`.
//! Panics at the first enclosure that misses; prints the number of comparisons for each metric and
//! the largest widths at points.

#[path = "../tests/it/every_metric/mod.rs"]
mod every_metric;
#[path = "../../tautline-scalar/tests/it/precise/mod.rs"]
mod precise;
#[path = "../../tautline-scalar/tests/it/reference/mod.rs"]
mod reference;

use std::thread;

use every_metric::{Record, Trial, try_all};
use precise::Tally;
use reference::Random;

/// The number of parallel trials, each with its own random numbers.
const TRIALS: u64 = 4;

fn trial(seed: u64, comparisons: u64) -> Vec<Record> {
    let mut trial = Trial { random: Random(seed), comparisons, records: Vec::new() };
    try_all(&mut trial);
    trial.records
}

fn main() {
    let argument = |n: usize, default: u64| {
        std::env::args().nth(n).map_or(default, |text| text.parse().expect("a number"))
    };
    let (count, seed) = (argument(1, 1_000_000), argument(2, 1041));
    let each = count.div_ceil(TRIALS * trial(seed, 0).len() as u64);
    let mut trials = thread::scope(|scope| {
        let trials: Vec<_> =
            (1..=TRIALS).map(|i| scope.spawn(move || trial(seed + i, each))).collect();
        trials.into_iter().map(|trial| trial.join().expect("no miss")).collect::<Vec<_>>()
    });
    let mut records = trials.pop().expect("a trial");
    for other in &trials {
        records.iter_mut().zip(other).for_each(|(record, other)| record.add(other));
    }
    let mut all = Tally::default();
    for Record { name, dimension, tally, widest: [h, first, second] } in records {
        println!(
            "{name}, D = {dimension}: {} compared, none missed; widest at points, in 2⁻⁵² of the \
             largest entry: H {h:.1}, ∂H {first:.1}, ∂²H {second:.1}",
            tally.compared
        );
        all.add(tally);
    }
    println!("seed {seed}: {all:?}");
}
