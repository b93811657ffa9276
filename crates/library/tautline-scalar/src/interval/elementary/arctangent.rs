//! The arctangent by IEEE operations.

use super::{
    circular::{TINY, a_little_less},
    constants::{ARCCOT_OF_EIGHTHS, ARCTAN_OF_EIGHTHS},
};
use crate::interval::{
    approximation::Approximation,
    directed::two_sum,
    series::{U, horner, over_odd_numbers},
};

/// The coefficients `1/(2j+3)`.
const COEFFICIENTS: [f64; 7] = over_odd_numbers(1.0);

/// Returns bounds on `arctan x`.
#[inline]
pub(crate) fn atan(x: f64) -> (f64, f64) {
    if x.abs() < TINY {
        // The difference from x is at most |x|³/3.
        return a_little_less(x);
    }
    let y = of_positive(x.abs());
    if x < 0.0 { (-y).bounds() } else { y.bounds() }
}

/// Approximates `arctan x` for `x ≥ 2⁻²⁶`, infinity included.
///
/// For `x ≤ 1`, `arctan x = arctan c + arctan τ`, where `τ = (x − c)/(1 + x c)` and `c` is the
/// eighth nearest to `x`. For `x > 1`, `arctan x = (π/2 − arctan c) + arctan τ`, where
/// `τ = (c x − 1)/(x + c)` and `c` is the eighth nearest to `1/x`. In both cases
/// `|τ| ≤ 1/16 + 2⁻⁵⁰`. The series is `arctan τ = τ − τ w p(−w)`, with `w = τ²` and
/// `p(−w) = Σ (−w)ʲ/(2j+3)`. Its errors, in units of `u |τ w|`, are at most `0.68` from Horner's
/// scheme with `q = 0.004`, `1.01` from `w` and the two products, and `0.01` from the truncation,
/// `w⁷/17`. Together they are less than `2 u |τ w|`, or `0.008 u` relative to `τ`.
///
/// * If `c = 0` and `x ≤ 1`, `τ = x` is exact, and the tail is a single number. The error is at
///   most `2 u |x| w`.
/// * If `c > 0` and `x ≤ 1`, `x − c` is exact, as `c/2 ≤ x ≤ 2 c`. `1 + x c` has two roundings and
///   the quotient has one, so the error of `τ` is `3.01 u |τ|`.
/// * If `x > 1`, the error of `c x ≤ 2` is at most `u` (0 for `c = 0`). `c x − 1` is exact
///   (`1/2 ≤ c x ≤ 2` unless `c = 0`). The divisor and the quotient have an error of `u` each. As
///   `x + c > 3/2`, the error of `τ` is `2.01 u |τ| + 0.67 u`. If `x` is close to the largest
///   double, `τ` may be subnormal, with an error of `2⁻¹⁰⁷⁵`.
///
/// In the last two cases the sum of the tail is rounded twice, which contributes at most
/// `2 u (|τ w|/3 · 1.01 + 3 u) ≤ 0.003 u |τ| + 6 u²`, and the error of the constant is `2⁻¹⁰⁶`.
/// Together these are at most `4 u |τ| + 2⁻¹⁰²`, plus `0.67 u` if `x > 1` and `c > 0`.
#[inline]
pub(crate) fn of_positive(x: f64) -> Approximation {
    let (tau, (head, low), error) = if x <= 1.0 {
        let j = (8.0 * x).round();
        if j == 0.0 {
            let w = x * x;
            let tail = -(x * (w * horner(-w, &COEFFICIENTS)));
            return Approximation { head: x, tail, error: 2.0 * U * (x * w) };
        }
        let c = j / 8.0;
        ((x - c) / (1.0 + x * c), ARCTAN_OF_EIGHTHS[index(j)], SMALL)
    } else {
        let j = (8.0 / x).round();
        let c = j / 8.0;
        let more = if j == 0.0 { SMALL } else { 0.75 * U };
        // For x = ∞ this gives the limit.
        let tau = if c == 0.0 { -(1.0 / x) } else { (c * x - 1.0) / (x + c) };
        (tau, ARCCOT_OF_EIGHTHS[index(j)], more)
    };
    let w = tau * tau;
    let (head, s) = two_sum(head, tau);
    let tail = (low - tau * (w * horner(-w, &COEFFICIENTS))) + s;
    Approximation { head, tail, error: 4.0 * U * tau.abs() + error }
}

/// Returns the index of the eighth with numerator `j`.
#[inline]
fn index(j: f64) -> usize {
    j as usize
}

/// The number `2⁻¹⁰²`.
const SMALL: f64 = f64::from_bits((1023 - 102) << 52);
