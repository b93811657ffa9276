//! Hyperbolic sine, cosine and tangent by IEEE operations.
//!
//! Up to `|x| = 1` by the series of the circular functions with the other sign, so that nothing
//! cancels near zero; beyond by the exponential function.

use super::{
    circular::{TINY, a_little_less, a_little_more},
    directed::{add_down, add_up, div_down, div_up},
    even_odd::{even, odd},
    exponential::{exp, exp_times_power},
};

/// Bounds of `sinh x`.
#[inline]
pub(super) fn sinh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // sinh x ≤ x + 0.2 x³ there.
        return a_little_more(x);
    }
    let (lo, hi) = if size <= 1.0 {
        odd(size, 0.0, 0.0, 1.0).bounds()
    } else {
        let (lo, hi) = exp_times_power(size, -1);
        if size <= 40.0 {
            // (eˣ − 1/eˣ)/2, where the quarter of the reciprocal of eˣ/2 is e⁻ˣ/2.
            (add_down(lo, -div_up(0.25, lo)), add_up(hi, -div_down(0.25, hi)))
        } else if size <= 711.0 {
            // e⁻ˣ/2 is less than 2⁻¹⁰⁰ of eˣ/2.
            (lo.next_down(), hi)
        } else {
            // Beyond 2¹⁰²⁴ by far.
            (lo, hi)
        }
    };
    if x < 0.0 { (-hi, -lo) } else { (lo, hi) }
}

/// Bounds of `cosh x`.
#[inline]
pub(super) fn cosh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // cosh x ≤ 1 + 0.6 x² < 1 + 2⁻⁵² there.
        return (1.0, if x == 0.0 { 1.0 } else { 1.0_f64.next_up() });
    }
    if size <= 1.0 {
        return even(size, 0.0, 0.0, 1.0).bounds();
    }
    let (lo, hi) = exp_times_power(size, -1);
    if size <= 40.0 {
        (add_down(lo, div_down(0.25, hi)), add_up(hi, div_up(0.25, lo)))
    } else {
        (lo, hi.next_up())
    }
}

/// Bounds of `tanh x`.
#[inline]
pub(super) fn tanh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // |x| − |x|³/3 and more.
        return a_little_less(x);
    }
    let (lo, hi) = if size <= 1.0 {
        let (s, c) = (sinh(size), cosh(size));
        (div_down(s.0, c.1), div_up(s.1, c.0))
    } else if size < 20.0 {
        // 1 − 2/(e²ˣ + 1); the double of x is exact.
        let (lo, hi) = exp(2.0 * size);
        let (less, least) = (div_up(2.0, add_down(lo, 1.0)), div_down(2.0, add_up(hi, 1.0)));
        (add_down(1.0, -less), add_up(1.0, -least))
    } else {
        // 2 e⁻⁴⁰ < 2⁻⁵³.
        (1.0_f64.next_down(), 1.0)
    };
    if x < 0.0 { (-hi, -lo) } else { (lo, hi) }
}
