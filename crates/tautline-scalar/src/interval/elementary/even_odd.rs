//! The two series behind sine, cosine and their hyperbolic counterparts.
//!
//! With `S(w) = Σ wʲ/(2j+1)!` and `C(w) = Σ wʲ/(2j)!` we have `sin h = h S(−h²)`, `cos h = C(−h²)`,
//! `sinh h = h S(h²)` and `cosh h = C(h²)`: one series and one error bound for each pair.

use crate::interval::{
    approximation::Approximation,
    directed::two_sum,
    series::{U, horner, reciprocals_of_factorials},
};

/// `1/(2j+3)!`.
const ODD: [f64; 8] = reciprocals_of_factorials(3, 2);

/// `1/(2j+4)!`.
const EVEN: [f64; 8] = reciprocals_of_factorials(4, 2);

/// `sin` (`sign = −1`) or `sinh` (`sign = 1`) of `h + t + δ`, `|δ| ≤ e`.
///
/// Needs: `2⁻³⁰⁰ ≤ |h| ≤ 1`, `|t| ≤ u |h|`; and `|h| ≤ 0.7855` unless `t = 0 = e`.
///
/// **The error is at most `2 u |h| h² + 2⁻¹⁰² |h| + e`.** Let `p(w) = (S(w) − 1)/w`, and `w` the
/// rounded `±h²`. In units of `u |h w|`: Horner with `q = 1/20` contributes `2.01/6/0.95² ≤ 0.38`;
/// `|p| ≤ sinh 1 − 1 ≤ 0.176`, so the two products add `0.352`; the rounding of `w` adds
/// `|(w p)′| ≤ (cosh 1 − sinh 1)/2 ≤ 0.184`; truncation, `|w|⁸/19!` and less, adds `0.08`. Adding
/// the part of `t` rounds the sum: at most `0.176`, and `2 u² |h|`. Last,
/// `sin(h + t) − sin h = t cos ξ`, and `1 − h²/2` differs from `cos ξ` by `h⁴/24 + |t|`: at most
/// `0.03`, and `u² |h|`; the three roundings of that part are `3 u² |h|`. Together `1.21 u |h w|`
/// and `6 u² |h| < 2⁻¹⁰³ |h|`. The derivative is at most 1, so `δ` contributes `e`; for `sinh`,
/// `e = 0`.
#[inline]
pub(crate) fn odd(h: f64, t: f64, e: f64, sign: f64) -> Approximation {
    let z = h * h;
    let w = sign * z;
    let tail = h * (w * horner(w, &ODD)) + t * (1.0 - 0.5 * z);
    Approximation { head: h, tail, error: h.abs() * (2.0 * U * z + SMALL) + e }
}

/// `cos` (`sign = −1`) or `cosh` (`sign = 1`) of `h + t + δ`, `|δ| ≤ e`.
///
/// Needs: as for [`odd`].
///
/// **The error is at most `2 u h² + e`.** Let `p(w) = (C(w) − 1 − w/2)/w²`, and `w` the rounded
/// `±h²`. The rounding of `w` moves `w/2` by `0.5 u |w|`; `1 + w/2` is then split exactly into a
/// head and `s`, where `|s| ≤ min(u, |w|/2)`. In units of `u w²`: Horner with `q = 1/30`
/// contributes `2.01/24/0.966² ≤ 0.09`; `|p| ≤ cosh 1 − 3/2 ≤ 0.0431`, so the two products add
/// `0.087`; the rounding of `w` adds `(sinh 1 − 1)/2 ≤ 0.088`; truncation, `w⁸/20!` and less, adds
/// `0.01`. The two roundings of the sum of the tail are at most
/// `0.09 u w² + u min(u, |w|/2) + u² h²`, of which the second is less than `0.5 u |w|`. Last,
/// `cos(h + t) − cos h = −t sin ξ`, and `|sin ξ − h| ≤ |h|³/6 + |t|`: at most `0.17 u h⁴ + 3 u² h²`
/// with the roundings of that part. Together at most `1.6 u h²`. The derivative is at most 1, so
/// `δ` contributes `e`.
#[inline]
pub(crate) fn even(h: f64, t: f64, e: f64, sign: f64) -> Approximation {
    let z = h * h;
    let w = sign * z;
    let (head, s) = two_sum(1.0, 0.5 * w);
    let tail = s + (w * (w * horner(w, &EVEN)) + sign * (h * t));
    Approximation { head, tail, error: 2.0 * U * z + e }
}

/// `2⁻¹⁰²`.
const SMALL: f64 = f64::from_bits((1023 - 102) << 52);
