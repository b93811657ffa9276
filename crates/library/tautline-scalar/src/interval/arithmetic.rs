//! The operations `+ − × ÷` of intervals.
//!
//! On real intervals each operation attains its extremes at end points, and the signs decide at
//! which ones. Each extreme is one operation on doubles, rounded outward. The result is therefore
//! the smallest interval that contains all values. If a product or quotient nearly overflows or
//! underflows, it may be one double wider at each end.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{
    Enclosure,
    directed::{add_down, add_up, div_down, div_up, mul_down, mul_up},
    kernel::Kernel,
};

impl<K: Kernel> Neg for Enclosure<K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        if self.is_undefined() { self } else { Self::enclosing(-self.hi(), -self.lo()) }
    }
}

impl<K: Kernel> Add for Enclosure<K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        // This is never ∞ − ∞: no lower end is +∞, and no upper end is −∞.
        Self::enclosing(add_down(self.lo(), other.lo()), add_up(self.hi(), other.hi()))
    }
}

impl<K: Kernel> Sub for Enclosure<K> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<K: Kernel> Mul for Enclosure<K> {
    type Output = Self;
    /// Zero times an interval with an infinite end is the whole line. The infinite end may come
    /// from an overflow, and in `f64` the product would be NaN.
    #[inline]
    fn mul(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        let ((a, b), (c, d)) = ((self.lo(), self.hi()), (other.lo(), other.hi()));
        let (lo, hi) = if a >= 0.0 {
            if c >= 0.0 {
                (mul_down(a, c), mul_up(b, d))
            } else if d <= 0.0 {
                (mul_down(b, c), mul_up(a, d))
            } else {
                (mul_down(b, c), mul_up(b, d))
            }
        } else if b <= 0.0 {
            if c >= 0.0 {
                (mul_down(a, d), mul_up(b, c))
            } else if d <= 0.0 {
                (mul_down(b, d), mul_up(a, c))
            } else {
                (mul_down(a, d), mul_up(a, c))
            }
        } else if c >= 0.0 {
            (mul_down(a, d), mul_up(b, d))
        } else if d <= 0.0 {
            (mul_down(b, c), mul_up(a, c))
        } else {
            // No end is 0 here, so no product is NaN, which `min` and `max` would ignore.
            (mul_down(a, d).min(mul_down(b, c)), mul_up(a, c).max(mul_up(b, d)))
        };
        // 0 · ∞ is NaN.
        if lo.is_nan() || hi.is_nan() { Self::REALS } else { Self::enclosing(lo, hi) }
    }
}

impl<K: Kernel> Div for Enclosure<K> {
    type Output = Self;
    /// The result is undefined if the divisor contains zero.
    #[inline]
    fn div(self, other: Self) -> Self {
        let ((a, b), (c, d)) = ((self.lo(), self.hi()), (other.lo(), other.hi()));
        if self.is_undefined() {
            return self;
        }
        let (lo, hi) = if c > 0.0 {
            let lo = if a >= 0.0 { div_down(a, d) } else { div_down(a, c) };
            (lo, if b >= 0.0 { div_up(b, c) } else { div_up(b, d) })
        } else if d < 0.0 {
            let lo = if b >= 0.0 { div_down(b, d) } else { div_down(b, c) };
            (lo, if a >= 0.0 { div_up(a, c) } else { div_up(a, d) })
        } else {
            return Self::UNDEFINED;
        };
        // This is never ∞ / ∞: an infinite end of the divisor divides the end of `self` closer to
        // 0, which is finite.
        Self::enclosing(lo, hi)
    }
}

crate::operators_follow!([K: Kernel] Enclosure<K>);
