//! Hyperbolic sine, cosine and tangent by IEEE operations.
//!
//! Up to `|x| = 1` the code uses the series of the circular functions with the other sign, so that
//! nothing cancels near zero. Beyond that it uses the exponential function.

use super::{
    circular::{TINY, a_little_less, a_little_more},
    even_odd::{even, odd},
    exponential::{exp, exp_times_power},
};
use crate::interval::enclosure::Interval;

/// Returns bounds on `sinh x`.
#[inline]
pub(crate) fn sinh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // In this range sinh x ≤ x + 0.2 x³.
        return a_little_more(x);
    }
    let (lo, hi) = if size <= 1.0 {
        odd(size, 0.0, 0.0, 1.0).bounds()
    } else {
        let (lo, hi) = exp_times_power(size, -1);
        if size <= 40.0 {
            // sinh x = (eˣ − 1/eˣ)/2, where e⁻ˣ/2 is a quarter of the reciprocal of eˣ/2.
            let half = Interval::enclosing(lo, hi);
            ends(half - 0.25 / half)
        } else if size <= 711.0 {
            // e⁻ˣ/2 is less than 2⁻¹⁰⁰ times eˣ/2.
            (lo.next_down(), hi)
        } else {
            // The value is far beyond 2¹⁰²⁴.
            (lo, hi)
        }
    };
    if x < 0.0 { (-hi, -lo) } else { (lo, hi) }
}

/// Returns bounds on `cosh x`.
#[inline]
pub(crate) fn cosh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // In this range cosh x ≤ 1 + 0.6 x² < 1 + 2⁻⁵².
        return (1.0, if x == 0.0 { 1.0 } else { 1.0_f64.next_up() });
    }
    if size <= 1.0 {
        return even(size, 0.0, 0.0, 1.0).bounds();
    }
    let (lo, hi) = exp_times_power(size, -1);
    if size <= 40.0 {
        let half = Interval::enclosing(lo, hi);
        ends(half + 0.25 / half)
    } else {
        (lo, hi.next_up())
    }
}

/// Returns bounds on `tanh x`.
#[inline]
pub(crate) fn tanh(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size < TINY {
        // tanh x ≥ x − x³/3.
        return a_little_less(x);
    }
    let (lo, hi) = if size <= 1.0 {
        let [sinh, cosh] = [sinh(size), cosh(size)].map(|(lo, hi)| Interval::enclosing(lo, hi));
        ends(sinh / cosh)
    } else if size < 20.0 {
        // tanh x = 1 − 2/(e²ˣ + 1), where 2x is exact.
        let (lo, hi) = exp(2.0 * size);
        ends(1.0 - 2.0 / (Interval::enclosing(lo, hi) + 1.0))
    } else {
        // 2 e⁻⁴⁰ < 2⁻⁵³.
        (1.0_f64.next_down(), 1.0)
    };
    if x < 0.0 { (-hi, -lo) } else { (lo, hi) }
}

fn ends(x: Interval) -> (f64, f64) {
    (x.lo(), x.hi())
}

#[cfg(test)]
mod tests {
    use super::{cosh, exp_times_power, sinh};

    /// The bounds allow for `sinh x < eˣ/2 < cosh x`, however tight the bounds on `eˣ/2` are.
    #[test]
    fn sinh_and_cosh_of_large_arguments_are_on_either_side_of_the_exponential() {
        for k in 0..2700 {
            let x = 40.5 + 0.25 * f64::from(k);
            let (lo, hi) = exp_times_power(x, -1);
            if hi < f64::INFINITY {
                assert!(sinh(x).0 < lo && sinh(-x).1 > -lo && cosh(x).1 > hi, "{x}");
            }
        }
    }
}
