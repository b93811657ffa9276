//! Compares enclosures of random formulas and of their derivatives over boxes with values computed
//! in high precision, a million times.
//!
//! The tests make a hundred thousand comparisons. This example takes ten seconds:
//! `cargo run --release -p tautline-scalar --example formulas_by_the_million [COUNT] [SEED]`. It
//! panics at the first enclosure that misses a value.

#[path = "../tests/it/formulas/mod.rs"]
mod formulas;
#[path = "../tests/it/precise/mod.rs"]
mod precise;
#[path = "../tests/it/reference/mod.rs"]
mod reference;

use formulas::{Formula, attempt};
use precise::Tally;
use reference::Random;

fn main() {
    let argument = |n: usize, default: u64| {
        std::env::args().nth(n).map_or(default, |text| text.parse().expect("a number"))
    };
    let (count, seed) = (argument(1, 1_000_000), argument(2, 1031));
    let mut random = Random(seed);
    let mut formulas = 0_u64;
    let mut tally = Tally::default();
    while tally.compared < count {
        let depth = 1 + (random.bits() % 6) as u32;
        attempt(&Formula::random(depth, &mut random), &mut random, &mut tally);
        formulas += 1;
    }
    println!("seed {seed}: {formulas} formulas, none missed; {tally:?}");
}
