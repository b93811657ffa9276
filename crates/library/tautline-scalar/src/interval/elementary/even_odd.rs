//! The two series behind sine, cosine and their hyperbolic counterparts.
//!
//! With `S(w) = Σ wʲ/(2j+1)!` and `C(w) = Σ wʲ/(2j)!` we have `sin h = h S(−h²)`, `cos h = C(−h²)`,
//! `sinh h = h S(h²)` and `cosh h = C(h²)`. One series and one error bound thus serve each pair.

use crate::interval::{
    approximation::Approximation,
    directed::two_sum,
    series::{U, horner, reciprocals_of_factorials},
};

/// The coefficients `1/(2j+3)!`.
const ODD: [f64; 8] = reciprocals_of_factorials(3, 2);

/// The coefficients `1/(2j+4)!`.
const EVEN: [f64; 8] = reciprocals_of_factorials(4, 2);

/// Approximates `sin` (`sign = −1`) or `sinh` (`sign = 1`) of `h + t + δ`, where `|δ| ≤ e`.
///
/// Needs: `2⁻³⁰⁰ ≤ |h| ≤ 1` and `|t| ≤ u |h|`; and `|h| ≤ 0.7855` unless `t = 0 = e`.
///
/// **The error is at most `2 u |h| h² + 2⁻¹⁰² |h| + e`.** Let `p(w) = (S(w) − 1)/w`, and let `w` be
/// the rounded `±h²`. In units of `u |h w|`, Horner's scheme with `q = 1/20` contributes
/// `2.01/6/0.95² ≤ 0.38`. Since `|p| ≤ sinh 1 − 1 ≤ 0.176`, the two products contribute `0.352`.
/// The rounding of `w` contributes `|(w p)′| ≤ (cosh 1 − sinh 1)/2 ≤ 0.184`. The truncation, at
/// most `|w|⁸/19!`, contributes `0.08`. Adding the part from `t` rounds the sum, which contributes
/// at most `0.176`, plus `2 u² |h|`. Finally, `sin(h + t) − sin h = t cos ξ`, and `1 − h²/2`
/// differs from `cos ξ` by `h⁴/24 + |t|`, which contributes at most `0.03`, plus `u² |h|`; the
/// three roundings of this part contribute `3 u² |h|`. The total is `1.21 u |h w|` plus
/// `6 u² |h| < 2⁻¹⁰³ |h|`. The derivative is at most 1, so `δ` contributes `e`; for `sinh`,
/// `e = 0`.
#[inline]
pub(crate) fn odd(h: f64, t: f64, e: f64, sign: f64) -> Approximation {
    let z = h * h;
    let w = sign * z;
    let tail = h * (w * horner(w, &ODD)) + t * (1.0 - 0.5 * z);
    Approximation { head: h, tail, error: h.abs() * (2.0 * U * z + SMALL) + e }
}

/// Approximates `cos` (`sign = −1`) or `cosh` (`sign = 1`) of `h + t + δ`, where `|δ| ≤ e`.
///
/// Needs: the same as [`odd`].
///
/// **The error is at most `2 u h² + e`.** Let `p(w) = (C(w) − 1 − w/2)/w²`, and let `w` be the
/// rounded `±h²`. The rounding of `w` changes `w/2` by `0.5 u |w|`. Then `1 + w/2` is split exactly
/// into a head and `s`, where `|s| ≤ min(u, |w|/2)`. In units of `u w²`, Horner's scheme with
/// `q = 1/30` contributes `2.01/24/0.966² ≤ 0.09`. Since `|p| ≤ cosh 1 − 3/2 ≤ 0.0431`, the two
/// products contribute `0.087`. The rounding of `w` contributes `(sinh 1 − 1)/2 ≤ 0.088`. The
/// truncation, at most `w⁸/20!`, contributes `0.01`. The two roundings of the sum of the tail are
/// at most `0.09 u w² + u min(u, |w|/2) + u² h²`, where the second term is less than `0.5 u |w|`.
/// Finally, `cos(h + t) − cos h = −t sin ξ`, and `|sin ξ − h| ≤ |h|³/6 + |t|`, which contributes at
/// most `0.17 u h⁴ + 3 u² h²`, including the roundings of this part. The total is at most
/// `1.6 u h²`. The derivative is at most 1, so `δ` contributes `e`.
#[inline]
pub(crate) fn even(h: f64, t: f64, e: f64, sign: f64) -> Approximation {
    let z = h * h;
    let w = sign * z;
    let (head, s) = two_sum(1.0, 0.5 * w);
    let tail = s + (w * (w * horner(w, &EVEN)) + sign * (h * t));
    Approximation { head, tail, error: 2.0 * U * z + e }
}

/// The number `2⁻¹⁰²`.
const SMALL: f64 = f64::from_bits((1023 - 102) << 52);
