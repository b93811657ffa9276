//! Sine, cosine and tangent by IEEE operations.

use super::{
    Interval,
    approximation::Approximation,
    even_odd::{even, odd},
    quarter_turns::QuarterTurns,
};

/// Below this, `2⁻²⁶`, a function with `f(x) = x + O(x³)` differs from `x` by less than a place.
pub(super) const TINY: f64 = f64::from_bits((1023 - 26) << 52);

/// Bounds of a function of which `|x| − |x|³/2 ≤ |f(x)| ≤ |x|` is known, for `|x| < 2⁻²⁶`.
///
/// `|x|³/2 < 2⁻⁵³ |x|`, and the neighbour of `x` is at least as far as that, also below a power of
/// two; a subnormal has neighbours farther away still.
#[inline]
pub(super) fn a_little_less(x: f64) -> (f64, f64) {
    if x == 0.0 {
        (x, x)
    } else if x > 0.0 {
        (x.next_down(), x)
    } else {
        (x, x.next_up())
    }
}

/// Bounds of a function of which `|x| ≤ |f(x)| ≤ |x| + |x|³/2` is known, for `|x| < 2⁻²⁶`.
#[inline]
pub(super) fn a_little_more(x: f64) -> (f64, f64) {
    if x == 0.0 {
        (x, x)
    } else if x > 0.0 {
        (x, x.next_up())
    } else {
        (x.next_down(), x)
    }
}

/// Bounds between `−1` and `1`.
#[inline]
fn clipped(y: Approximation) -> (f64, f64) {
    let (lo, hi) = y.bounds();
    (lo.max(-1.0), hi.min(1.0))
}

/// Sine and cosine of an angle, not near zero.
#[inline]
pub(super) fn approximations(x: f64) -> (Approximation, Approximation) {
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

/// Bounds of `sin x` and of `cos x`, for `|x| ≤ 2²⁰`.
#[inline]
pub(super) fn sin_cos(x: f64) -> ((f64, f64), (f64, f64)) {
    if x.abs() < TINY {
        // sin: |x|³/6. cos: 1 − x²/2 ≥ 1 − 2⁻⁵³.
        let below = if x == 0.0 { 1.0 } else { 1.0_f64.next_down() };
        return (a_little_less(x), (below, 1.0));
    }
    let (s, c) = approximations(x);
    (clipped(s), clipped(c))
}

/// Bounds of `sin x`, for `|x| ≤ 2²⁰`.
#[inline]
pub(super) fn sin(x: f64) -> (f64, f64) {
    if x.abs() < TINY { a_little_less(x) } else { clipped(one(x, 0)) }
}

/// Bounds of `cos x`, for `|x| ≤ 2²⁰`.
#[inline]
pub(super) fn cos(x: f64) -> (f64, f64) {
    if x.abs() < TINY { sin_cos(x).1 } else { clipped(one(x, 1)) }
}

/// The sine of `x` and so many quarter turns.
#[inline]
fn one(x: f64, more: i32) -> Approximation {
    let angle = QuarterTurns::of(x);
    let QuarterTurns { head: h, tail: t, error: e, .. } = angle;
    match (angle.quadrant() + more) & 3 {
        0 => odd(h, t, e, -1.0),
        1 => even(h, t, e, -1.0),
        2 => -odd(h, t, e, -1.0),
        _ => -even(h, t, e, -1.0),
    }
}

/// Bounds of `tan x`, for `|x| ≤ 2²⁰`: those of the sine by those of the cosine.
#[inline]
pub(super) fn tan(x: f64) -> (f64, f64) {
    if x.abs() < TINY {
        // tan x < x + 0.4 x³ there.
        return a_little_more(x);
    }
    let (s, c) = approximations(x);
    let ((s0, s1), (c0, c1)) = (s.bounds(), c.bounds());
    let quotient = Interval::enclosing(s0, s1) / Interval::enclosing(c0, c1);
    // Undefined only if the cosine were not separated from zero; then there is no bound.
    if quotient.is_undefined() {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    (quotient.lo(), quotient.hi())
}
