//! `valley_jump`: the minimisers of the discrete lengths of Section 5.

use std::f64::consts::TAU;

use nalgebra::SVector;
use tautline::PointSequence;

/// Returns the sequence of `n + 1` points that rests at `(0, 0)`, is at `(2π, 0)` from the step
/// `leave` on, and at `(4π, 0)` from the step `arrive` on.
///
/// For `1 ≤ leave ≤ arrive ≤ n`, these are the `n(n + 1)/2` minimisers of the left-endpoint length
/// over the valleys, and there are no others. Those with `leave = arrive` jump over both ridges at
/// once; they are the `n` minimisers of the trapezoidal length, and again there are no others.
#[must_use]
pub fn valley_jump(n: usize, leave: usize, arrive: usize) -> PointSequence<2> {
    let valley = |k: usize| f64::from(u8::from(k >= leave) + u8::from(k >= arrive));
    let points = (0..=n.max(1)).map(|k| SVector::from([TAU * valley(k), 0.0])).collect();
    PointSequence::new(points).expect("two finite points at least")
}
