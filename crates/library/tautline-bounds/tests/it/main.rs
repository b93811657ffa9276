//! Tests of the bounds against reference values, by their properties, and in special cases.

mod bend;
mod golden;
mod outward;
mod panics;
mod properties;
mod properties_sharper;
mod special_cases;
mod spread;

use std::num::NonZeroUsize;

use proptest::prelude::*;
use tautline_bounds::{Constants, Setting};

fn n(n: usize) -> NonZeroUsize {
    NonZeroUsize::new(n).expect("positive")
}

fn setting(c1: f64, c2: f64, l_h: f64, distance: f64, dimension: usize) -> Setting {
    let constants = Constants::new(c1, c2, l_h).expect("in order");
    Setting::new(constants, distance, dimension).expect("a distance")
}

/// Draws `10^x` with `x` uniform in the range.
fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|x| 10_f64.powf(x))
}
