//! `Enclosure`: a closed interval of real numbers, or *undefined*.

use std::{fmt, marker::PhantomData};

use super::{
    IntervalError,
    directed::{add_down, add_up},
    kernel::{Kernel, Rigorous},
};

/// An interval whose elementary functions rely only on the IEEE operations `+ − × ÷ √`.
pub type Interval = Enclosure<Rigorous>;

/// A closed interval `[lo, hi]` of real numbers, or *undefined*.
///
/// Every operation returns an interval that contains all values that it can take for real numbers
/// in its arguments. The ends are doubles; `lo = −∞` or `hi = ∞` means that there is no bound on
/// that side. The type parameter is the kernel of the elementary functions: see [`Interval`] and
/// [`FastInterval`](super::FastInterval).
///
/// # Undefined
///
/// An *undefined* interval has NaN for both ends. It results from a quotient whose divisor contains
/// zero, from a root or a logarithm whose argument contains a number outside the domain, from a
/// tangent whose argument may contain a pole, and from anything made from NaN or an infinite
/// number. Every operation on an undefined interval is undefined, including multiplication by zero
/// and `x⁰`. A formula that is undefined at one point of a box is therefore undefined on the box,
/// and never gets a finite enclosure. (Returning the whole line would not suffice, since its
/// arctangent is finite.) Compare ends so that NaN fails: discard a box only
/// `if x.hi() <= best { … }`.
///
/// If a number overflows, the interval is infinite but defined.
///
/// # Equality
///
/// Intervals are equal if their ends are equal. An undefined interval equals nothing, not even
/// itself. Intervals have no order.
#[derive(Clone, Copy, PartialEq)]
pub struct Enclosure<K> {
    // Invariant: either lo ≤ hi, lo < ∞ and hi > −∞, or both are NaN.
    lo: f64,
    hi: f64,
    kernel: PhantomData<K>,
}

impl<K: Kernel> Enclosure<K> {
    /// The real line.
    pub const REALS: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY, kernel: PhantomData };

    /// The undefined interval.
    pub const UNDEFINED: Self = Self { lo: f64::NAN, hi: f64::NAN, kernel: PhantomData };

    /// Returns `[lo, hi]`.
    ///
    /// # Errors
    ///
    /// If an end is NaN, if `lo > hi`, or if both ends are the same infinity.
    pub fn new(lo: f64, hi: f64) -> Result<Self, IntervalError> {
        if lo.is_nan() || hi.is_nan() {
            Err(IntervalError::NotANumber { lo, hi })
        } else if !(lo <= hi) {
            Err(IntervalError::Inverted { lo, hi })
        } else if lo == hi && lo.is_infinite() {
            Err(IntervalError::NoRealNumber { lo, hi })
        } else {
            Ok(Self::enclosing(lo, hi))
        }
    }

    /// Returns `[x, x]`, which is undefined unless `x` is finite.
    #[must_use]
    pub fn point(x: f64) -> Self {
        if x.is_finite() { Self::enclosing(x, x) } else { Self::UNDEFINED }
    }

    /// Returns `[lo, hi]`. An end that is NaN, or an infinity of the wrong sign, is replaced by the
    /// infinity of the right sign, that is, by no bound.
    ///
    /// Needs: `lo ≤ hi` unless one of them is NaN.
    #[inline]
    pub(super) fn enclosing(lo: f64, hi: f64) -> Self {
        debug_assert!(!(lo > hi), "{lo} > {hi}");
        Self {
            lo: if lo < f64::INFINITY { lo } else { f64::NEG_INFINITY },
            hi: if hi > f64::NEG_INFINITY { hi } else { f64::INFINITY },
            kernel: PhantomData,
        }
    }

    /// Returns the same interval with another kernel.
    #[must_use]
    pub fn with_kernel<L: Kernel>(self) -> Enclosure<L> {
        Enclosure { lo: self.lo, hi: self.hi, kernel: PhantomData }
    }

    /// Returns the lower end, or NaN if the interval is undefined.
    #[must_use]
    #[inline]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Returns the upper end, or NaN if the interval is undefined.
    #[must_use]
    #[inline]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Returns whether the interval is undefined.
    #[must_use]
    #[inline]
    pub fn is_undefined(self) -> bool {
        self.lo.is_nan()
    }

    /// Returns whether both ends are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Returns `hi − lo`, rounded up, or NaN if the interval is undefined.
    #[must_use]
    pub fn width(self) -> f64 {
        add_up(self.hi, -self.lo)
    }

    /// Returns a finite number in the interval: the centre, up to rounding, if both ends are
    /// finite, and `±f64::MAX` or 0 otherwise. Returns NaN if the interval is undefined.
    #[must_use]
    #[doc(alias = "centre")]
    pub fn midpoint(self) -> f64 {
        match (self.lo.is_finite(), self.hi.is_finite()) {
            // Adding halves prevents overflow. Half a subnormal is rounded, so the sum may lie
            // outside the interval, hence the clamp.
            (true, true) => (0.5 * self.lo + 0.5 * self.hi).clamp(self.lo, self.hi),
            (true, false) => f64::MAX,
            (false, true) => f64::MIN,
            _ if self.is_undefined() => f64::NAN,
            _ => 0.0,
        }
    }

    /// Returns the largest `|x|` in the interval, or NaN if the interval is undefined.
    #[must_use]
    #[doc(alias = "mag")]
    pub fn magnitude(self) -> f64 {
        // Either both are NaN or neither is, so `max` ignores none.
        self.lo.abs().max(self.hi.abs())
    }

    /// Returns the smallest `|x|` in the interval, or NaN if the interval is undefined.
    #[must_use]
    #[doc(alias = "mig")]
    pub fn mignitude(self) -> f64 {
        if self.contains(0.0) { 0.0 } else { self.lo.abs().min(self.hi.abs()) }
    }

    /// Returns whether the real number `x` lies in the interval; false if the interval is
    /// undefined.
    #[must_use]
    #[inline]
    pub fn contains(self, x: f64) -> bool {
        x.is_finite() && self.lo <= x && x <= self.hi
    }

    /// Returns whether `other` lies in the interval; false if either is undefined.
    #[must_use]
    pub fn contains_interval(self, other: Self) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Returns the intersection: `None` if it is empty, and undefined if either interval is
    /// undefined.
    #[must_use]
    pub fn intersection(self, other: Self) -> Option<Self> {
        if self.is_undefined() || other.is_undefined() {
            return Some(Self::UNDEFINED);
        }
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then(|| Self::enclosing(lo, hi))
    }

    /// Returns the smallest interval that contains both; it is undefined if either interval is.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        Self::enclosing(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// Returns the distance from the midpoint to the farther end, rounded up, or NaN if undefined.
    #[must_use]
    pub fn radius(self) -> f64 {
        let centre = self.midpoint();
        add_up(self.hi, -centre).max(-add_down(self.lo, -centre))
    }
}

impl<K> fmt::Debug for Enclosure<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.lo.is_nan() {
            write!(f, "undefined")
        } else {
            write!(f, "[{:?}, {:?}]", self.lo, self.hi)
        }
    }
}
