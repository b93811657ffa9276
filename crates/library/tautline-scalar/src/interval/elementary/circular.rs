//! Sine, cosine and tangent by IEEE operations.

use super::{
    even_odd::{even, odd},
    quarter_turns::QuarterTurns,
};
use crate::interval::{Interval, approximation::Approximation};

/// Below this number, `2⁻²⁶`, a function `f(x) = x + O(x³)` differs from `x` by less than one unit
/// in the last place.
pub(crate) const TINY: f64 = f64::from_bits((1023 - 26) << 52);

/// Returns bounds on an odd function with `|x| − |x|³/2 ≤ |f(x)| ≤ |x|`, for `|x| < 2⁻²⁶`.
///
/// Here `|x|³/2 < 2⁻⁵³ |x|`, and the neighbours of `x` are at least that far away, even just below
/// a power of two. The neighbours of a subnormal are farther away.
#[inline]
pub(crate) fn a_little_less(x: f64) -> (f64, f64) {
    if x == 0.0 {
        (x, x)
    } else if x > 0.0 {
        (x.next_down(), x)
    } else {
        (x, x.next_up())
    }
}

/// Returns bounds on an odd function with `|x| ≤ |f(x)| ≤ |x| + |x|³/2`, for `|x| < 2⁻²⁶`.
#[inline]
pub(crate) fn a_little_more(x: f64) -> (f64, f64) {
    if x == 0.0 {
        (x, x)
    } else if x > 0.0 {
        (x, x.next_up())
    } else {
        (x.next_down(), x)
    }
}

/// Returns bounds on `y`, which is known to lie in `[−1, 1]`.
#[inline]
fn clipped(y: Approximation) -> (f64, f64) {
    let (lo, hi) = y.bounds();
    (lo.max(-1.0), hi.min(1.0))
}

/// Approximates the sine and the cosine, for `|x| ≥ 2⁻²⁶`.
#[inline]
pub(crate) fn approximations(x: f64) -> (Approximation, Approximation) {
    let angle = QuarterTurns::of(x);
    let QuarterTurns { head: h, tail: t, error: e, .. } = angle;
    let (s, c) = (odd(h, t, e, -1.0), even(h, t, e, -1.0));
    match angle.quadrant() {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// Returns bounds on `sin x` and on `cos x`, for `|x| ≤ 2³⁸`.
#[inline]
pub(crate) fn sin_cos(x: f64) -> ((f64, f64), (f64, f64)) {
    if x.abs() < TINY {
        // The sine differs from x by at most |x|³/6, and cos x ≥ 1 − x²/2 ≥ 1 − 2⁻⁵³.
        let below = if x == 0.0 { 1.0 } else { 1.0_f64.next_down() };
        return (a_little_less(x), (below, 1.0));
    }
    let (s, c) = approximations(x);
    (clipped(s), clipped(c))
}

/// Returns bounds on `sin x`, for `|x| ≤ 2³⁸`.
#[inline]
pub(crate) fn sin(x: f64) -> (f64, f64) {
    if x.abs() < TINY { a_little_less(x) } else { clipped(one(x, 0)) }
}

/// Returns bounds on `cos x`, for `|x| ≤ 2³⁸`.
#[inline]
pub(crate) fn cos(x: f64) -> (f64, f64) {
    if x.abs() < TINY { sin_cos(x).1 } else { clipped(one(x, 1)) }
}

/// Approximates the sine of `x + more π/2`.
#[inline]
fn one(x: f64, more: i64) -> Approximation {
    let angle = QuarterTurns::of(x);
    let QuarterTurns { head: h, tail: t, error: e, .. } = angle;
    match (angle.quadrant() + more) & 3 {
        0 => odd(h, t, e, -1.0),
        1 => even(h, t, e, -1.0),
        2 => -odd(h, t, e, -1.0),
        _ => -even(h, t, e, -1.0),
    }
}

/// Returns bounds on `tan x`, for `|x| ≤ 2³⁸`: the quotient of the bounds on the sine and the
/// cosine.
#[inline]
pub(crate) fn tan(x: f64) -> (f64, f64) {
    if x.abs() < TINY {
        // In this range tan x < x + 0.4 x³.
        return a_little_more(x);
    }
    let (s, c) = approximations(x);
    let ((s0, s1), (c0, c1)) = (s.bounds(), c.bounds());
    let quotient = Interval::enclosing(s0, s1) / Interval::enclosing(c0, c1);
    // The quotient is undefined only if the bounds on the cosine do not exclude zero.
    if quotient.is_undefined() {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    (quotient.lo(), quotient.hi())
}
