//! The four operations and the square root, rounded downward and upward.
//!
//! `v = fl(a ∘ b)` is the double nearest to the true value, which therefore lies between the
//! neighbours of `v`. The sign of the residual `a ∘ b − v` tells on which side of `v` it lies. If
//! the residual is zero, `v` is exact and serves as both bounds.
//!
//! The residual of a sum is a double, and Knuth's TwoSum computes it exactly. For products,
//! Dekker's algorithm does the same without a fused multiply-add, provided that nothing overflows
//! and that no part of the product falls below the smallest subnormal. The residuals `a − q b` of a
//! quotient and `a − s²` of a root are doubles too, for the rounded results `q` and `s`. Outside
//! these ranges the neighbour serves as the bound, which is always valid.

/// Which bound is wanted.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Below,
    Above,
}

/// Returns a bound on a number whose nearest double is `value`, given a number with the sign of the
/// residual, or NaN if the residual is unknown.
///
/// A zero has the sign of the number that underflowed to it, so it is a bound itself: `+0` from
/// below, and `−0` from above.
#[inline]
fn beside(value: f64, residual: f64, side: Side) -> f64 {
    match side {
        Side::Below if residual >= 0.0 || value.to_bits() == 0.0_f64.to_bits() => value,
        Side::Below => value.next_down(),
        Side::Above if residual <= 0.0 || value.to_bits() == (-0.0_f64).to_bits() => value,
        Side::Above => value.next_up(),
    }
}

/// Returns `(s, e)` with `s = fl(a + b)` and `s + e = a + b` exactly, unless the sum overflows.
///
/// This is Knuth's TwoSum. A sum of doubles never underflows, and the intermediate values are at
/// most `2 max(|a|, |b|)`.
#[inline]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let from_b = s - a;
    let from_a = s - from_b;
    (s, (a - from_a) + (b - from_b))
}

/// Returns `(p, e)` with `p = fl(a b)` and `p + e = a b` exactly; `e` is NaN if that is not
/// guaranteed.
///
/// This is Dekker's product, with Veltkamp's halves of 26 bits. The splitting multiplies by
/// `2²⁷ + 1`, which overflows only beyond `2⁹⁹⁶`. The product of the upper halves is at most
/// `(1 + 2⁻²⁵) |a b|`. The residual is a multiple of the product of the last places of `a` and `b`,
/// which is at least `2⁻¹⁰⁶ |p|`. This exceeds the smallest subnormal, `2⁻¹⁰⁷⁴`, if `|p| ≥ 2⁻⁹⁶⁰`.
/// In that case no partial product has places below it either.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    const LARGE: f64 = f64::from_bits((1023 + 990) << 52);
    const LARGEST: f64 = f64::from_bits((1023 + 1021) << 52);
    const SMALL: f64 = f64::from_bits((1023 - 960) << 52);
    let p = a * b;
    if !(a.abs() <= LARGE && b.abs() <= LARGE && p.abs() <= LARGEST && p.abs() >= SMALL) {
        // A product is zero without underflow only if one of its factors is zero.
        let zero = (a == 0.0 && b.is_finite()) || (b == 0.0 && a.is_finite());
        return (p, if zero { 0.0 } else { f64::NAN });
    }
    let (a1, a2) = halves(a);
    let (b1, b2) = halves(b);
    (p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2)
}

/// Splits `a = a₁ + a₂` into parts with at most 26 bits each.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    let c = a * 134_217_729.0;
    let a1 = c - (c - a);
    (a1, a - a1)
}

#[inline]
fn add(a: f64, b: f64, side: Side) -> f64 {
    // Beyond 2¹⁰²² the intermediate values of the residual might overflow.
    const LARGE: f64 = f64::from_bits((1023 + 1022) << 52);
    let (s, e) = two_sum(a, b);
    let certain = a.abs() <= LARGE && b.abs() <= LARGE;
    beside(s, if certain { e } else { f64::NAN }, side)
}

#[inline]
fn mul(a: f64, b: f64, side: Side) -> f64 {
    let (p, e) = two_product(a, b);
    beside(p, e, side)
}

#[inline]
fn div(a: f64, b: f64, side: Side) -> f64 {
    let q = a / b;
    if a == 0.0 && b != 0.0 && !b.is_nan() {
        return q;
    }
    // a − q b is a double (it has at most 53 bits, by the rounding of q), and so is a − fl(q b).
    // Both are computed exactly if the residual of the product is known. The quotient lies above q
    // if the residual has the sign of b. If the quotient underflowed, the neighbours serve as
    // bounds.
    let (p, e) = two_product(q, b);
    let residual = if q.abs() >= f64::MIN_POSITIVE && a.is_finite() && b.is_finite() {
        (a - p) - e
    } else {
        f64::NAN
    };
    beside(q, if b < 0.0 { -residual } else { residual }, side)
}

#[inline]
fn sqrt(a: f64, side: Side) -> f64 {
    let s = a.sqrt();
    if a == 0.0 || a == f64::INFINITY {
        return s;
    }
    let (p, e) = two_product(s, s);
    beside(s, (a - p) - e, side)
}

macro_rules! on_either_side {
    ($($operation:ident, $down:ident, $up:ident ($($x:ident),*): $of:literal;)*) => {$(
        #[doc = concat!("A lower bound on ", $of)]
        #[inline]
        pub(super) fn $down($($x: f64),*) -> f64 {
            $operation($($x,)* Side::Below)
        }

        #[doc = concat!("An upper bound on ", $of)]
        #[inline]
        pub(super) fn $up($($x: f64),*) -> f64 {
            $operation($($x,)* Side::Above)
        }
    )*};
}

on_either_side! {
    add, add_down, add_up(a, b): "`a + b`.";
    mul, mul_down, mul_up(a, b): "`a b`; NaN for `0 · ∞`.";
    div, div_down, div_up(a, b): "`a / b`, for `b ≠ 0`; NaN for `∞ / ∞`.";
    sqrt, sqrt_down, sqrt_up(a): "`√a`, for `a ≥ 0`.";
}
