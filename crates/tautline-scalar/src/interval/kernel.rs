//! `Kernel`: how elementary functions are enclosed at a double.

use std::fmt::Debug;

use super::{arctangent, circular, exponential, hyperbolic, logarithm};

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Rigorous {}
    impl Sealed for super::super::Fast {}
}

/// How the elementary functions are enclosed at one double: [`Rigorous`] or [`Fast`].
///
/// Sealed, since the intervals rely on what each method promises: two numbers, the first at most
/// and the second at least the true value, or the limit at an infinite argument.
///
/// [`Fast`]: super::Fast
pub trait Kernel: sealed::Sealed + Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Returns bounds of `eˣ`.
    fn exp(x: f64) -> (f64, f64);
    /// Returns bounds of `ln x`, for `x > 0`.
    fn ln(x: f64) -> (f64, f64);
    /// Returns bounds of `sin x` and of `cos x`, for `|x| ≤ 2²⁰`.
    fn sin_cos(x: f64) -> ((f64, f64), (f64, f64));
    /// Returns bounds of `sin x`, for `|x| ≤ 2²⁰`.
    fn sin(x: f64) -> (f64, f64);
    /// Returns bounds of `cos x`, for `|x| ≤ 2²⁰`.
    fn cos(x: f64) -> (f64, f64);
    /// Returns bounds of `tan x`, for `|x| ≤ 2²⁰`.
    fn tan(x: f64) -> (f64, f64);
    /// Returns bounds of `arctan x`.
    fn atan(x: f64) -> (f64, f64);
    /// Returns bounds of `sinh x`.
    fn sinh(x: f64) -> (f64, f64);
    /// Returns bounds of `cosh x`.
    fn cosh(x: f64) -> (f64, f64);
    /// Returns bounds of `tanh x`.
    fn tanh(x: f64) -> (f64, f64);
}

/// Series with bounded remainders and bounded roundings: nothing is trusted but that `+ − × ÷ √`
/// of doubles are rounded to nearest.
///
/// The widest enclosures of points among a million for each function, in units of `2⁻⁵²` of the
/// value (which is a place or half of one): 2.2 for `exp`, 4.4 for `ln`, 2.9 for `sin` and
/// `cos`, 7 for `tan`, 5 for `atan`, 4.1 for `sinh`, 3.6 for `cosh`, 6.7 for `tanh`. They are
/// relative to the value near its zeros too: nothing cancels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigorous;

impl Kernel for Rigorous {
    #[inline]
    fn exp(x: f64) -> (f64, f64) {
        exponential::exp(x)
    }
    #[inline]
    fn ln(x: f64) -> (f64, f64) {
        logarithm::ln(x)
    }
    #[inline]
    fn sin_cos(x: f64) -> ((f64, f64), (f64, f64)) {
        circular::sin_cos(x)
    }
    #[inline]
    fn sin(x: f64) -> (f64, f64) {
        circular::sin(x)
    }
    #[inline]
    fn cos(x: f64) -> (f64, f64) {
        circular::cos(x)
    }
    #[inline]
    fn tan(x: f64) -> (f64, f64) {
        circular::tan(x)
    }
    #[inline]
    fn atan(x: f64) -> (f64, f64) {
        arctangent::atan(x)
    }
    #[inline]
    fn sinh(x: f64) -> (f64, f64) {
        hyperbolic::sinh(x)
    }
    #[inline]
    fn cosh(x: f64) -> (f64, f64) {
        hyperbolic::cosh(x)
    }
    #[inline]
    fn tanh(x: f64) -> (f64, f64) {
        hyperbolic::tanh(x)
    }
}
