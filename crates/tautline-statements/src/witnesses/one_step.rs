//! Point sequences that rest but for one step.

use nalgebra::SVector;
use tautline::PointSequence;

/// Returns `n + 1` points on the line that rest at 0, go to 1 in the step `step < n`, and rest there;
/// with `n = 0` the one step of `n = 1`.
///
/// `mean |β|³ = N²` and `K₃ = √N`: the one case in which Proposition 7.8 is an equality.
#[must_use]
pub fn one_step(n: usize, step: usize) -> PointSequence<1> {
    let n = n.max(1);
    let at = |k: usize| SVector::from([if k <= step.min(n - 1) { 0.0 } else { 1.0 }]);
    PointSequence::new((0..=n).map(at).collect()).expect("two finite points at least")
}
