//! `Enclosure`: a closed interval of real numbers, or the mark that a formula is not defined.

use std::{fmt, marker::PhantomData};

use super::{
    IntervalError,
    directed::{add_down, add_up},
    kernel::{Kernel, Rigorous},
};

/// An interval whose elementary functions trust nothing but IEEE `+ − × ÷ √`.
pub type Interval = Enclosure<Rigorous>;

/// A closed interval `[lo, hi]` of real numbers, or *undefined*.
///
/// Every operation returns an interval that contains all values of the operation on the real
/// numbers in its arguments. The ends are doubles; `lo = −∞` and `hi = ∞` are allowed and mean
/// that there is no bound on that side: an infinite end is not a value. The type parameter says
/// how the elementary functions are evaluated: see [`Interval`] and
/// [`FastInterval`](super::FastInterval).
///
/// # Undefined
///
/// The quotient by an interval that contains zero, the root of one that reaches below zero, the
/// logarithm of one that reaches to zero, the tangent of one that may contain a pole, and anything
/// made from a NaN or from an infinite number are *undefined*: both ends are NaN. Every operation
/// on an undefined interval is undefined, multiplication by zero and `x⁰` included, so a formula
/// that is undefined at one point of a box is undefined on the box and never gets a finite
/// enclosure. The whole line would not do as the mark, since the arctangent of it is finite. Code
/// that compares ends must be written so that NaN fails: discard a box only
/// `if x.hi() <= best { … }`.
///
/// An interval may also be infinite, where a number overflows: the real value is defined, and
/// the enclosure says so.
///
/// # Equality
///
/// Two intervals are equal if their ends are; an undefined one equals nothing, itself included.
/// There is no order.
#[derive(Clone, Copy, PartialEq)]
pub struct Enclosure<K> {
    // Invariant: lo ≤ hi, lo < ∞ and hi > −∞; or both are NaN.
    lo: f64,
    hi: f64,
    kernel: PhantomData<K>,
}

impl<K: Kernel> Enclosure<K> {
    /// The real line.
    pub const REALS: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY, kernel: PhantomData };

    /// The mark that a formula is not defined.
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

    /// Returns the interval that contains the one number `x`; undefined unless `x` is finite.
    #[must_use]
    pub fn point(x: f64) -> Self {
        if x.is_finite() { Self::enclosing(x, x) } else { Self::UNDEFINED }
    }

    /// Bounds from below and above of something that is defined: a bound that is NaN or the wrong
    /// infinity is no bound, and becomes the right infinity.
    ///
    /// Needs: `lo ≤ hi` where both are numbers.
    #[inline]
    pub(super) fn enclosing(lo: f64, hi: f64) -> Self {
        debug_assert!(!(lo > hi), "{lo} > {hi}");
        Self {
            lo: if lo < f64::INFINITY { lo } else { f64::NEG_INFINITY },
            hi: if hi > f64::NEG_INFINITY { hi } else { f64::INFINITY },
            kernel: PhantomData,
        }
    }

    /// Returns the same numbers, for evaluation by another kernel.
    #[must_use]
    pub fn with_kernel<L: Kernel>(self) -> Enclosure<L> {
        Enclosure { lo: self.lo, hi: self.hi, kernel: PhantomData }
    }

    /// Returns the lower end; NaN if undefined.
    #[must_use]
    #[inline]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Returns the upper end; NaN if undefined.
    #[must_use]
    #[inline]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Returns whether this is the mark that a formula is not defined.
    #[must_use]
    #[inline]
    pub fn is_undefined(self) -> bool {
        self.lo.is_nan()
    }

    /// Returns whether both ends are finite numbers.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Returns `hi − lo`, rounded up; NaN if undefined.
    #[must_use]
    pub fn width(self) -> f64 {
        add_up(self.hi, -self.lo)
    }

    /// Returns a finite number inside, the centre up to rounding where both ends are finite, and
    /// the largest double where only the upper end is infinite; NaN if undefined.
    #[must_use]
    #[doc(alias = "centre")]
    pub fn midpoint(self) -> f64 {
        match (self.lo.is_finite(), self.hi.is_finite()) {
            // Halves, so that the sum does not overflow. The half of a subnormal rounds, and the
            // sum of the halves may then lie outside: hence the clamp.
            (true, true) => (0.5 * self.lo + 0.5 * self.hi).clamp(self.lo, self.hi),
            (true, false) => f64::MAX,
            (false, true) => f64::MIN,
            _ if self.is_undefined() => f64::NAN,
            _ => 0.0,
        }
    }

    /// Returns the largest `|x|` of all `x` in the interval; NaN if undefined.
    #[must_use]
    #[doc(alias = "mag")]
    pub fn magnitude(self) -> f64 {
        // Both or neither are NaN, so `max` drops none.
        self.lo.abs().max(self.hi.abs())
    }

    /// Returns the smallest `|x|` of all `x` in the interval; NaN if undefined.
    #[must_use]
    #[doc(alias = "mig")]
    pub fn mignitude(self) -> f64 {
        if self.contains(0.0) { 0.0 } else { self.lo.abs().min(self.hi.abs()) }
    }

    /// Returns whether the real number `x` lies in the interval; false if undefined.
    #[must_use]
    #[inline]
    pub fn contains(self, x: f64) -> bool {
        x.is_finite() && self.lo <= x && x <= self.hi
    }

    /// Returns whether every number of `other` lies in the interval; false if either is undefined.
    #[must_use]
    pub fn contains_interval(self, other: Self) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Returns the numbers in both; `None` if there are none. Undefined if either is.
    #[must_use]
    pub fn intersection(self, other: Self) -> Option<Self> {
        if self.is_undefined() || other.is_undefined() {
            return Some(Self::UNDEFINED);
        }
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then(|| Self::enclosing(lo, hi))
    }

    /// Returns the smallest interval that contains both; undefined if either is.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        Self::enclosing(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// Returns the distance of the midpoint to the farther end, rounded up; NaN if undefined.
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
