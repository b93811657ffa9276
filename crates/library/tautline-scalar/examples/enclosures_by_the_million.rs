//! Compares a million arguments of each elementary function, with both kernels, with high
//! precision.
//!
//! The tests try twenty thousand arguments. This example takes some minutes:
//! `cargo run --release -p tautline-scalar --example enclosures_by_the_million [COUNT]`. It panics
//! at the first enclosure that misses a value, and otherwise prints the greatest widths.

#[path = "../tests/it/reference/mod.rs"]
mod reference;

use std::thread;

use reference::{FAMILIES, Random, Reference, Widest, argument, attempt};

fn main() {
    let count = std::env::args().nth(1).map_or(1_000_000, |n| n.parse().expect("a number"));
    thread::scope(|scope| {
        for (which, family) in FAMILIES.into_iter().enumerate() {
            scope.spawn(move || {
                let mut reference = Reference::new();
                let mut random = Random(1000 + which as u64);
                let mut widest = vec![[Widest::default(); 2]; family.len()];
                for _ in 0..count {
                    let x = argument(family, &mut random);
                    attempt(family, x, &mut reference, &mut random, &mut widest);
                }
                for (f, [rigorous, fast]) in family.iter().zip(&widest) {
                    println!(
                        "{f:?}: {count} arguments, none missed; widest, in 2⁻⁵² of the value and \
                         of 1: rigorous {:.2} {:.3e}, fast {:.2} {:.3e}",
                        rigorous.relative, rigorous.absolute, fast.relative, fast.absolute
                    );
                }
            });
        }
    });
}
