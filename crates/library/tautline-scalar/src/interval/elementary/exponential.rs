//! The exponential function by IEEE operations.

use super::constants::LN_2;
use crate::interval::{
    approximation::Approximation,
    directed::two_sum,
    series::{U, horner, reciprocals_of_factorials},
};

/// The coefficients `1/(j+2)!`.
const COEFFICIENTS: [f64; 12] = reciprocals_of_factorials(2, 1);

/// Returns bounds on `eˣ`.
#[inline]
pub(crate) fn exp(x: f64) -> (f64, f64) {
    exp_times_power(x, 0)
}

/// Returns bounds on `2ⁿ eˣ`, for `n = −1` or `0`.
///
/// The range of the doubles ends before `e⁷¹¹ / 2 > 2¹⁰²⁴` and `e⁻⁷⁴⁶ < 2⁻¹⁰⁷⁵`.
#[inline]
pub(crate) fn exp_times_power(x: f64, n: i32) -> (f64, f64) {
    if x > 711.0 {
        return (f64::MAX, f64::INFINITY);
    }
    if !(x >= -746.0) {
        // Intervals never pass NaN.
        let above = if x == f64::NEG_INFINITY { 0.0 } else { f64::from_bits(1) };
        return (0.0, above);
    }
    if x == 0.0 {
        return (power_of_two(n), power_of_two(n));
    }
    let (k, y) = reduced(x);
    let (lo, hi) = y.bounds();
    (scaled(lo, k + n, f64::next_down).clamp(0.0, f64::MAX), scaled(hi, k + n, f64::next_up))
}

/// Returns an integer `k` and an approximation of `eˣ / 2ᵏ`, which lies in `(0.7, 1.42)`.
///
/// Needs: `|x| ≤ 746`.
///
/// Let `k` be the integer nearest to the rounded `x / ln 2`. The splitting `x = k ln 2 + r` is
/// valid for any `k`, and `|r| ≤ 0.3466` since the error of the quotient is below `2⁻⁴⁰`. The
/// product `k L₀` is exact (42 + 11 bits), and so is `x − k L₀`: for `k ≠ 0` we have `|x| > 0.346`,
/// so that both are multiples of `2⁻⁵⁴`, and their difference is less than `0.5`. The product
/// `k L₁` is rounded by at most `u · 2¹¹⁻⁴²`, and `|k ε| ≤ 2¹¹⁻⁹⁶`. Together these are at most
/// `e = 2⁻⁸³`. Hence `r = h + t + δ` with `|t| ≤ u |h|` and `|δ| ≤ e`.
///
/// **The error is at most `6 u h² + 2⁻¹⁰² + 1.5 e`.** Let `p(h) = (eʰ − 1 − h)/h²`. In units of
/// `u h²`, Horner's scheme with `q = |h|/3 ≤ 0.116` contributes `2.01/2/0.884² ≤ 1.29`. Since
/// `p ≤ 0.564`, the two products contribute `1.13`. The truncation, `1.04 |h|¹²/14!`, contributes
/// `0.33`. For the part from `t`, `eʰ⁺ᵗ − eʰ = t exp ξ`, and `1 + h` differs from `exp ξ` by
/// `0.6 h² + 1.5 |t|`, which contributes at most `0.21`, plus `1.5 u² h²`. Then `1 + h` is split
/// exactly into a head and a part of the tail, which is at most `u`. The tail is summed with three
/// roundings, which contribute `3 · 0.564`, plus `9 u²`. The total is `4.7 u h²` plus `12 u²`. The
/// derivative is at most `1.42`, so `δ` contributes `1.5 e`.
#[inline]
pub(crate) fn reduced(x: f64) -> (i32, Approximation) {
    let k = (x * std::f64::consts::LOG2_E).round_ties_even();
    let (h, t) = two_sum(x - k * LN_2[0], -(k * LN_2[1]));
    let (head, s) = two_sum(1.0, h);
    let z = h * h;
    let tail = ((z * horner(h, &COEFFICIENTS) + t * h) + t) + s;
    // The bound is 2⁻¹⁰², plus 1.5 · 2⁻⁸³ if a multiple of ln 2 was subtracted.
    let small = if k == 0.0 { power_of_two(-102) } else { power_of_two(-82) };
    (k as i32, Approximation { head, tail, error: 6.0 * U * z + small })
}

/// Returns `2ⁿ`, for `−1022 ≤ n ≤ 1023`.
#[inline]
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(u64::from((1023 + n).cast_unsigned()) << 52)
}

/// Returns a bound on `2ᵏ y` for `0.5 < y < 2`. The function `step` moves to the neighbour on the
/// side of the bound.
///
/// Multiplying by the first half of the power gives a normal number, so this is exact. The second
/// multiplication is exact unless the result is subnormal or overflows. If it overflows, `∞` is an
/// upper bound, and for a lower bound the caller clamps it to the largest double.
#[inline]
fn scaled(y: f64, k: i32, step: impl Fn(f64) -> f64) -> f64 {
    let half = k / 2;
    let scaled = y * power_of_two(half) * power_of_two(k - half);
    if scaled < f64::MIN_POSITIVE * 2.0 { step(scaled) } else { scaled }
}
