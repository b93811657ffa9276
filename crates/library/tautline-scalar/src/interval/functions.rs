//! Elementary functions of intervals: `Enclosure` as a [`Scalar`].

use std::sync::Arc;

use num_traits::One;

use super::{
    Enclosure,
    directed::{mul_down, mul_up, sqrt_down, sqrt_up},
    elementary::quarter_turns::{LARGEST_ANGLE, QuarterTurns},
    kernel::Kernel,
};
use crate::{Scalar, Table};

impl<K: Kernel> Enclosure<K> {
    /// Returns the image under an increasing function, given bounds on the function at a double.
    #[inline]
    fn increasing(self, f: impl Fn(f64) -> (f64, f64)) -> Self {
        if self.is_undefined() {
            return self;
        }
        let (lo, hi) = f(self.lo());
        Self::enclosing(lo, if self.lo() == self.hi() { hi } else { f(self.hi()).1 })
    }

    /// Returns integers `j ≤ k` such that `j < n ≤ k` for every multiple `n π/2` in the interval
    /// above its lower end. Returns `None` if an end is too large or undefined.
    #[inline]
    fn quarters(self) -> Option<(i64, i64)> {
        if !(self.magnitude() <= LARGEST_ANGLE) {
            return None;
        }
        let (lo, hi) = (QuarterTurns::of(self.lo()), QuarterTurns::of(self.hi()));
        Some((lo.floor().0, hi.floor().1))
    }

    /// Returns the image under sine (`shift = 1`) or cosine (`shift = 0`), given bounds at both
    /// ends.
    ///
    /// The function attains its extremes at the ends or at multiples `n π/2` with `n − shift` even.
    /// At these it is `1` if `n − shift` is a multiple of 4, and `−1` otherwise.
    #[inline]
    fn wave(ends: [(f64, f64); 2], (j, k): (i64, i64), shift: i64) -> Self {
        let [(a, b), (c, d)] = ends;
        let (mut lo, mut hi) = (a.min(c), b.max(d));
        // Four consecutive values of n include both extremes.
        for n in (j + 1)..=k.min(j + 5) {
            match (n - shift) & 3 {
                0 => hi = 1.0,
                2 => lo = -1.0,
                _ => {}
            }
        }
        Self::enclosing(lo, hi)
    }

    /// Returns the bounds on sine and cosine at an unknown angle.
    fn any_wave(self) -> Self {
        if self.is_undefined() { self } else { Self::enclosing(-1.0, 1.0) }
    }
}

/// Evaluates `f` at both ends, but only once if they are equal.
#[inline]
fn at_ends<T: Copy>(lo: f64, hi: f64, f: impl Fn(f64) -> T) -> [T; 2] {
    let first = f(lo);
    [first, if lo == hi { first } else { f(hi) }]
}

macro_rules! increasing {
    ($($function:ident)*) => {$(
        #[inline]
        fn $function(self) -> Self {
            self.increasing(K::$function)
        }
    )*};
}

impl<K: Kernel> Scalar for Enclosure<K> {
    increasing!(exp atan sinh tanh);

    /// Returns `[value, value]`, which is undefined unless `value` is finite.
    #[inline]
    fn constant(value: f64) -> Self {
        Self::point(value)
    }

    /// Undefined if an argument is, or if the table has no bounds.
    fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[Self]) -> Self {
        if u.len() != table.axes() || u.iter().any(|u| u.is_undefined()) {
            return Self::UNDEFINED;
        }
        let mut sides = [(0.0, 0.0); 3];
        sides.iter_mut().zip(u).for_each(|(side, u)| *side = (u.lo(), u.hi()));
        let bounds = table.bounds(&sides[..u.len()], orders);
        bounds.and_then(|(lo, hi)| Self::new(lo, hi).ok()).unwrap_or(Self::UNDEFINED)
    }

    #[inline]
    fn sqr(self) -> Self {
        if self.is_undefined() {
            return self;
        }
        let (near, far) = (self.mignitude(), self.magnitude());
        Self::enclosing(mul_down(near, near), mul_up(far, far))
    }

    /// Returns `xⁿ`. Even powers have no negative part. The result is undefined if `x` is, even for
    /// `n = 0`, and if `n < 0` and `x` contains zero.
    #[inline]
    fn powi(self, n: i32) -> Self {
        self.power(n)
    }

    /// Returns `1 / x`, which is undefined if `x` contains zero.
    #[inline]
    fn recip(self) -> Self {
        Self::one() / self
    }

    /// Returns `√x`, which is undefined if `x` contains a negative number.
    #[inline]
    fn sqrt(self) -> Self {
        if !(self.lo() >= 0.0) {
            return Self::UNDEFINED;
        }
        Self::enclosing(sqrt_down(self.lo()), sqrt_up(self.hi()))
    }

    /// Returns the natural logarithm, which is undefined unless `x` is positive.
    #[inline]
    fn ln(self) -> Self {
        if self.lo() > 0.0 { self.increasing(K::ln) } else { Self::UNDEFINED }
    }

    /// Returns `(sin x, cos x)`. Both are `[−1, 1]` if an end of `x` is beyond `2³⁸`.
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let Some(quarters) = self.quarters() else {
            return (self.any_wave(), self.any_wave());
        };
        let [(s0, c0), (s1, c1)] = at_ends(self.lo(), self.hi(), K::sin_cos);
        (Self::wave([s0, s1], quarters, 1), Self::wave([c0, c1], quarters, 0))
    }

    /// Returns `tan x`, which is undefined if `x` may contain a pole, and always if an end is
    /// beyond `2³⁸`.
    #[inline]
    fn tan(self) -> Self {
        let Some((j, k)) = self.quarters() else {
            return Self::UNDEFINED;
        };
        // The poles are at odd multiples of π/2.
        if ((j + 1)..=k.min(j + 2)).any(|n| n & 1 == 1) {
            return Self::UNDEFINED;
        }
        self.increasing(K::tan)
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        (self.sinh(), self.cosh())
    }

    // `sin` and `cos` compute only one half of `sin_cos`.
    #[inline]
    fn sin(self) -> Self {
        let Some(quarters) = self.quarters() else {
            return self.any_wave();
        };
        Self::wave(at_ends(self.lo(), self.hi(), K::sin), quarters, 1)
    }

    #[inline]
    fn cos(self) -> Self {
        let Some(quarters) = self.quarters() else {
            return self.any_wave();
        };
        Self::wave(at_ends(self.lo(), self.hi(), K::cos), quarters, 0)
    }

    #[inline]
    fn cosh(self) -> Self {
        if self.is_undefined() {
            return self;
        }
        Self::enclosing(K::cosh(self.mignitude()).0, K::cosh(self.magnitude()).1)
    }
}
