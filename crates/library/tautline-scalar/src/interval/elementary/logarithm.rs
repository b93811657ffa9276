//! The natural logarithm by IEEE operations.

use super::constants::LN_2;
use crate::interval::{
    approximation::Approximation,
    directed::two_sum,
    series::{U, horner, over_odd_numbers},
};

/// The coefficients `2/(2j+3)`.
const COEFFICIENTS: [f64; 10] = over_odd_numbers(2.0);

/// Returns bounds on `ln x`, for `x > 0`.
#[inline]
pub(crate) fn ln(x: f64) -> (f64, f64) {
    if x == 1.0 {
        return (0.0, 0.0);
    }
    if x == f64::INFINITY { (x, x) } else { of_positive(x).bounds() }
}

/// Approximates `ln x` for a finite `x > 0`.
///
/// Let `x = 2ᵏ (1 + f)`, where `−0.293 ≤ f ≤ 0.4143` is exact, and `s = f/(2 + f)`. Then
/// `ln(1 + f) = 2 artanh s = f − s (f − R)` with `R = Σ 2 s²ʲ/(2j + 1)` over `j ≥ 1`, since
/// `2 s = f − s f`. Here `|s| ≤ 0.5859 |f|` and `s² ≤ 0.02945`.
///
/// **For `k = 0` the error is at most `4 u f²`.** The errors of `c = −s (f − R)`, in units of
/// `u f²`, are the following. The relative error of `s`, `2.01 u`, contributes `1.3`. Horner's
/// scheme with `q = 0.0295`, its product and the `5.1 u` of `s²` give `R` an error of
/// `5.8 u s² ≤ 2 u f²`, which contributes `0.5`. The rounding of `f − R` contributes `0.65`, the
/// rounding of the product `0.65`, and the truncation, at most `|s| · 2 s²²/23`, contributes
/// `0.02`. The total is `3.12`.
///
/// **Otherwise it is at most `6 u f² + 2⁻⁸²`.** The product `k L₀` has 53 bits and is exact, `k L₁`
/// is rounded by at most `2⁻⁸⁵`, and `|k ε| ≤ 2⁻⁸⁵`. The sum of the tail, which includes the tail
/// `t` of `k L₀ + f`, takes two roundings, which are at most
/// `2 u (|c| + |k L₁| + |t|) ≤ 1.3 u f² + 2⁻⁸³`.
#[inline]
pub(crate) fn of_positive(x: f64) -> Approximation {
    let (k, m) = split(x);
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let w = s * s;
    let c = -s * (f - w * horner(w, &COEFFICIENTS));
    if k == 0.0 {
        return Approximation { head: f, tail: c, error: 4.0 * U * (f * f) };
    }
    let (head, t) = two_sum(k * LN_2[0], f);
    Approximation { head, tail: (c + k * LN_2[1]) + t, error: 6.0 * U * (f * f) + SMALL }
}

/// Splits `x = 2ᵏ m` with `0.707 ≤ m ≤ 1.4143`, exactly.
#[inline]
fn split(x: f64) -> (f64, f64) {
    const MANTISSA: u64 = (1 << 52) - 1;
    const SQRT_2: u64 = std::f64::consts::SQRT_2.to_bits() & MANTISSA;
    // Multiplying by 2⁵⁴ makes a subnormal number normal.
    let subnormal = x < f64::MIN_POSITIVE;
    let bits = if subnormal { x * 18_014_398_509_481_984.0 } else { x }.to_bits();
    let mantissa = bits & MANTISSA;
    let half = mantissa > SQRT_2;
    let exponent = (bits >> 52) as i32 - 1023 - if subnormal { 54 } else { 0 } + i32::from(half);
    (f64::from(exponent), f64::from_bits(mantissa | if half { 1022 << 52 } else { 1023 << 52 }))
}

/// The number `2⁻⁸²`.
const SMALL: f64 = f64::from_bits((1023 - 82) << 52);
