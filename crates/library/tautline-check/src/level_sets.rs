//! Rescaling by level sets: how fast a function may grow with its own values.
//!
//! Let `q_T ≥ max_T |∇φ|²` in the dual norm, for each simplex `T`. Let `f` be continuous, 0 up to
//! `t₀`, affine between `t_b` and `t_{b+1}` with a slope in `[0, s_b]`, and constant beyond the last
//! level, where `s_b² q_T ≤ 1` for all `T` on which `φ` takes values between these levels. Then
//! `f(φ)` changes along a curve by at most the length of the curve.

use crate::rounding::{add_down, add_up, div_down, mul_down, sqrt_up};

/// The number of bins. More bins cost time, fewer lose sharpness.
const BINS: usize = 4096;

/// Bounds that differ by less, relative to themselves, differ by rounding.
const SAME: f64 = 2e-14;

/// What is known of a function on a simplex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Growth {
    /// Its least and its greatest value, or less and more.
    pub(crate) range: (f64, f64),
    /// A bound `q` on the squared dual norm of its gradient.
    pub(crate) q: f64,
}

/// The piecewise affine function `f` through the points `(t_b, F_b)`, and `e(t) = t − f(t)`.
#[derive(Debug)]
pub(crate) struct LevelSets {
    /// Increasing; empty if `f = 0`.
    levels: Vec<f64>,
    heights: Vec<f64>,
}

impl LevelSets {
    /// Returns the function from the level `start` to a little beyond the level `end`. It is 0 if
    /// there is no such interval.
    pub(crate) fn new(growths: impl Iterator<Item = Growth>, start: f64, end: f64) -> Self {
        let levels = levels(start, end);
        let mut largest = vec![0.0_f64; levels.len().saturating_sub(1)];
        for Growth { range: (low, high), q } in growths {
            // The bins that the open interval between low and high meets, found by comparison.
            let first = levels.partition_point(|&t| t <= low).saturating_sub(1);
            let past = levels.partition_point(|&t| t < high).min(largest.len());
            // A NaN would be ignored by a maximum.
            let q = if q.is_nan() { f64::INFINITY } else { q };
            for bin in largest.iter_mut().take(past).skip(first) {
                *bin = bin.max(q);
            }
        }
        let mut kept: Vec<f64> = levels.first().copied().into_iter().collect();
        let mut heights = vec![0.0_f64];
        let mut bins = levels.iter().skip(1).zip(&largest).peekable();
        let mut run = 0.0_f64;
        while let Some((&level, &q)) = bins.next() {
            run = run.max(q);
            // Bins with nearly the same bound are one, since every sum is rounded down. No bound is
            // near an infinite one.
            let tolerance = if run.is_finite() { SAME * run } else { 0.0 };
            if bins.peek().is_some_and(|&(_, &next)| (next - run).abs() <= tolerance) {
                continue;
            }
            let last = heights[heights.len() - 1];
            let rise = mul_down(add_down(level, -kept[kept.len() - 1]), slope(run));
            heights.push(last.max(add_down(last, rise)));
            kept.push(level);
            run = 0.0;
        }
        Self { levels: kept, heights }
    }

    /// Returns a lower bound on `f(t)`, not NaN. `t` may be infinite.
    pub(crate) fn below(&self, t: f64) -> f64 {
        let (levels, heights) = (&self.levels, &self.heights);
        let past = levels.partition_point(|&level| level <= t);
        if past == 0 || t.is_nan() {
            return 0.0;
        }
        if past == levels.len() {
            return heights[past - 1];
        }
        let (t0, t1, f0, f1) = (levels[past - 1], levels[past], heights[past - 1], heights[past]);
        let rise = mul_down(add_down(f1, -f0), add_down(t, -t0));
        // A rise that is unknown counts as none, so that the result is never NaN.
        add_down(f0, div_down(rise, add_up(t1, -t0))).max(f0).min(f1)
    }

    /// Returns an upper bound on `e(t) = t − f(t)`, which does not decrease.
    pub(crate) fn excess_above(&self, t: f64) -> f64 {
        add_up(t, -self.below(t))
    }
}

/// Returns the largest `s ≤ 1` with `s² q ≤ 1`, rounded down.
fn slope(q: f64) -> f64 {
    if q == 0.0 {
        1.0
    } else if q.is_finite() {
        div_down(1.0, sqrt_up(q)).min(1.0)
    } else {
        0.0
    }
}

/// Returns levels that increase from `start` to a tenth of the way beyond `end`.
///
/// They are rounded; that changes where the breakpoints are, and nothing else. The tenth makes
/// points behind the second set recognisable.
fn levels(start: f64, end: f64) -> Vec<f64> {
    let step = 1.1 * (end - start) / BINS as f64;
    if !(start.is_finite() && end.is_finite() && end > start && step.is_finite()) {
        return Vec::new();
    }
    let mut levels = vec![start];
    for b in 1..=BINS {
        let level = start + step * b as f64;
        // Near the largest double the last levels overflow.
        if level > levels[levels.len() - 1] && level.is_finite() {
            levels.push(level);
        }
    }
    levels
}

/// Returns a lower bound on the minimum of `f(φ) + g(ψ)` over a simplex, from the ranges of `φ` and
/// `ψ` and the least value of `φ + ψ` there.
///
/// Since `e` does not decrease, `f(φ) + g(ψ) = φ + ψ − e_f(φ) − e_g(ψ)` is at least the minimum of
/// the sum minus `e` at the greatest values. `f` and `g` at the least values are another bound.
pub(crate) fn least_sum(
    [f, g]: [&LevelSets; 2],
    [(low_u, high_u), (low_v, high_v)]: [(f64, f64); 2],
    sum: f64,
) -> f64 {
    let apart = add_down(f.below(low_u), g.below(low_v));
    let together = add_down(add_down(sum, -f.excess_above(high_u)), -g.excess_above(high_v));
    // If one is NaN, the other remains.
    apart.max(together)
}

#[cfg(test)]
mod tests;
