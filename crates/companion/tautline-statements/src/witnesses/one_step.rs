//! Point sequences that move in one step only.

use nalgebra::SVector;
use tautline::PointSequence;

/// Returns `n + 1` points on the line that rest at 0, move to 1 in the step `step < n`, and rest
/// there; `n = 0` counts as 1.
///
/// Then `mean |β|³ = N²` and `K₃ = √N`. This is the only case of equality in Proposition 7.8.
#[must_use]
pub fn one_step(n: usize, step: usize) -> PointSequence<1> {
    let n = n.max(1);
    let at = |k: usize| SVector::from([if k <= step.min(n - 1) { 0.0 } else { 1.0 }]);
    PointSequence::new((0..=n).map(at).collect()).expect("two finite points at least")
}
