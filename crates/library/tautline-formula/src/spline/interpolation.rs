//! The coefficients of the spline through given samples.

use super::{Spline, SplineError, check};

impl Spline {
    /// Returns the spline whose value at each node is the sample there, to rounding.
    ///
    /// The shape is as in [`new`](Self::new).
    ///
    /// # Border
    ///
    /// The value at node `i` of an axis is `(c_{i−1} + 4 c_i + c_{i+1}) / 6`. Beyond the border the
    /// nearest coefficient is repeated, so it is `(5 c₀ + c₁) / 6` at the first node, and likewise
    /// at the last. That is also what the mirror images of the samples at `−1/2` and `n − 1/2` would
    /// give. So between the first and the last node, the spline is the one through the samples and
    /// their mirror images, without end. What the border changes falls by `2 − √3 = 0.268` from one
    /// coefficient to the next.
    ///
    /// # Overshoot
    ///
    /// The spline may leave the range `[m − r, m + r]` of the samples. With `E` axes,
    ///
    /// - between the first and the last nodes, values stay in `m ± ((1 + 3√3)/4)ᴱ r`, which is
    ///   `1.55 r`, `2.40 r` or `3.72 r`;
    /// - everywhere, values stay in `m ± √3ᴱ r`, which is `1.74 r`, `3 r` or `5.20 r`;
    /// - coefficients, and so the bounds from [`range`](Self::range) and from an enclosure over many
    ///   cells, stay in `m ± 3ᴱ r`.
    ///
    /// For the proof, take `m = 0` and `r = 1`; constants are reproduced. Along one axis,
    /// `c_i = √3 Σ_j zᵏ s_j` with `k = |i − j|` and `z = √3 − 2`, summed over samples and mirror
    /// images. So `|c_i| ≤ √3 (1 + |z|)/(1 − |z|) = 3`. The coefficient `c₀` has each sample with its
    /// mirror image, `zᵏ + zᵏ⁺¹ = (1 − |z|) zᵏ`, so `|c₀| ≤ √3`. Beyond the first node, values lie
    /// between the first sample and `c₀`. Between nodes, `(1 + 3√3)/4` is the norm of the cardinal
    /// cubic spline interpolation, attained half-way between nodes by samples `…, −1, 1, 1, −1, …`
    /// that alternate on both sides. Axes are solved one after the other, so norms multiply.
    ///
    /// # Errors
    ///
    /// [`SplineError`] as in [`new`](Self::new), for samples and for the coefficients.
    pub fn interpolating(shape: &[usize], samples: Vec<f64>) -> Result<Self, SplineError> {
        check(shape, &samples)?;
        let mut numbers = samples;
        let mut stride = 1;
        for &length in shape.iter().rev() {
            let pivots = pivots(length);
            for block in numbers.chunks_exact_mut(length * stride) {
                solve(block, &pivots, stride);
            }
            stride *= length;
        }
        Self::new(shape, numbers)
    }
}

/// Returns the pivots of Gaussian elimination in the matrix with rows `1, 4, 1`, the first and the
/// last of which are `5, 1` and `1, 5`; a single row is `6`.
///
/// The matrix is diagonally dominant, so no rows need to be exchanged, and pivots are at least
/// `4 − 1/3`.
fn pivots(length: usize) -> Vec<f64> {
    let mut pivots = Vec::with_capacity(length);
    for i in 0..length {
        let ends = usize::from(i == 0) + usize::from(i + 1 == length);
        let below = pivots.last().map_or(0.0, |pivot: &f64| 1.0 / pivot);
        pivots.push(4.0 + ends as f64 - below);
    }
    pivots
}

/// Solves `stride` systems at once, whose unknowns are `stride` apart: six times the samples become
/// the coefficients.
fn solve(block: &mut [f64], pivots: &[f64], stride: usize) {
    for at in 0..block.len() {
        let before = if at < stride { 0.0 } else { block[at - stride] / pivots[at / stride - 1] };
        block[at] = 6.0 * block[at] - before;
    }
    for at in (0..block.len()).rev() {
        let after = block.get(at + stride).copied().unwrap_or(0.0);
        block[at] = (block[at] - after) / pivots[at / stride];
    }
}
