//! Numbers, intervals and jets, compared with arbitrary precision and an independent
//! implementation.

use tautline_scalar::Interval;

mod derivatives;
mod formulas;
mod hard_arguments;
mod interval_angles;
mod interval_edges;
mod interval_jets;
mod interval_laws;
mod interval_traps;
mod powers;
mod precise;
mod random_formulas;
mod reference;
mod tables;

const MAX: f64 = f64::MAX;
const INFINITY: f64 = f64::INFINITY;
/// The smallest positive double.
const LEAST: f64 = 5e-324;

#[track_caller]
fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).expect("ordered ends")
}

fn ends(x: Interval) -> (f64, f64) {
    (x.lo(), x.hi())
}
