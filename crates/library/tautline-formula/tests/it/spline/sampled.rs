//! Random splines, points and boxes.

use tautline_chance::Random;
use tautline_formula::spline::Spline;
use tautline_scalar::Interval;

/// The orders of derivatives on `axes` axes, each up to `most`.
pub(crate) fn all_orders(axes: usize, most: u8) -> Vec<[u8; 3]> {
    let base = usize::from(most) + 1;
    let digit = |k: usize, axis: u32| (k / base.pow(axis) % base) as u8;
    (0..base.pow(axes as u32)).map(|k| [digit(k, 0), digit(k, 1), digit(k, 2)]).collect()
}

/// The sum of the orders.
pub(crate) fn total(orders: [u8; 3]) -> i32 {
    orders.map(i32::from).iter().sum()
}

/// A shape of 1 to 3 axes with `least` to `most` coefficients on each.
pub(crate) fn shape(axes: usize, least: usize, most: usize, random: &mut Random) -> Vec<usize> {
    (0..axes).map(|_| least + (random.bits() % (most - least + 1) as u64) as usize).collect()
}

/// A spline of this shape. Its coefficients are of one size, or of very different sizes, or small
/// integers, many of which are equal.
pub(crate) fn spline(shape: &[usize], random: &mut Random) -> Spline {
    let kind = random.bits() % 3;
    let coefficient = |_| match kind {
        0 => random.between(-1.0, 1.0),
        1 => random.sign() * random.with_exponent(-40, 40),
        _ => (random.bits() % 5) as f64 - 2.0,
    };
    let coefficients = (0..shape.iter().product()).map(coefficient).collect();
    Spline::new(shape, coefficients).expect("finite numbers")
}

/// A coordinate on or near an axis of `n` coefficients: anywhere, at a node, next to one, or a tiny
/// one.
pub(crate) fn coordinate(n: usize, random: &mut Random) -> f64 {
    let anywhere = random.between(-3.0, n as f64 + 2.0);
    match random.bits() % 6 {
        0 => anywhere.round(),
        1 => anywhere.round().next_up(),
        2 => anywhere.round().next_down(),
        3 => random.sign() * random.with_exponent(-60, -2),
        _ => anywhere,
    }
}

/// A point on or near an array of this shape.
pub(crate) fn point(shape: &[usize], random: &mut Random) -> Vec<f64> {
    shape.iter().map(|&n| coordinate(n, random)).collect()
}

/// A side of a box: a point, a few doubles wide, in one cell, over some, or unbounded.
pub(crate) fn side(n: usize, random: &mut Random) -> Interval {
    let (a, b) = (coordinate(n, random), coordinate(n, random));
    let (a, b) = match random.bits() % 8 {
        0 => (a, a),
        1 => (a, a.next_up().next_up()),
        2 | 3 => (a, a + random.with_exponent(-20, -1)),
        4 => (a, a.ceil()),
        5 => (f64::NEG_INFINITY, a),
        6 => (a, f64::INFINITY),
        _ => (a.min(b), a.max(b)),
    };
    Interval::new(a, b).expect("ordered")
}

/// A box on or near an array of this shape.
pub(crate) fn sides(shape: &[usize], random: &mut Random) -> Vec<Interval> {
    shape.iter().map(|&n| side(n, random)).collect()
}

/// A number in the interval: an end, or one between, at most ten units beyond a finite end.
pub(crate) fn inside(x: Interval, random: &mut Random) -> f64 {
    let lo = if x.lo().is_finite() { x.lo() } else { x.hi().min(0.0) - 10.0 };
    let hi = if x.hi().is_finite() { x.hi() } else { x.lo().max(0.0) + 10.0 };
    match random.bits() % 6 {
        0 => lo,
        1 => hi,
        // A node, if there is one.
        2 => random.between(lo, hi).round().clamp(lo, hi),
        _ => random.between(lo, hi).clamp(lo, hi),
    }
}
