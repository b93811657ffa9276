//! `Kernel`: how the elementary functions are enclosed at a double.

use std::fmt::Debug;

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Rigorous {}
    impl Sealed for super::super::Fast {}
}

/// How the elementary functions are enclosed at one double: [`Rigorous`] or [`Fast`].
///
/// Each method returns a lower and an upper bound on the true value, or on the limit if the
/// argument is infinite. The trait is sealed, since intervals rely on these bounds.
///
/// [`Fast`]: super::Fast
pub trait Kernel: sealed::Sealed + Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Returns bounds on `eˣ`.
    fn exp(x: f64) -> (f64, f64);
    /// Returns bounds on `ln x`, for `x > 0`.
    fn ln(x: f64) -> (f64, f64);
    /// Returns bounds on `sin x` and on `cos x`, for `|x| ≤ 2³⁸`.
    fn sin_cos(x: f64) -> ((f64, f64), (f64, f64));
    /// Returns bounds on `sin x`, for `|x| ≤ 2³⁸`.
    fn sin(x: f64) -> (f64, f64);
    /// Returns bounds on `cos x`, for `|x| ≤ 2³⁸`.
    fn cos(x: f64) -> (f64, f64);
    /// Returns bounds on `tan x`, for `|x| ≤ 2³⁸`.
    fn tan(x: f64) -> (f64, f64);
    /// Returns bounds on `arctan x`.
    fn atan(x: f64) -> (f64, f64);
    /// Returns bounds on `sinh x`.
    fn sinh(x: f64) -> (f64, f64);
    /// Returns bounds on `cosh x`.
    fn cosh(x: f64) -> (f64, f64);
    /// Returns bounds on `tanh x`.
    fn tanh(x: f64) -> (f64, f64);
}

/// Series with bounds on truncation and rounding. This kernel relies only on `+ − × ÷ √` of doubles
/// being rounded to nearest.
///
/// The widest enclosures among a million points for each function, in units of `2⁻⁵²` times the
/// value (which is one unit in the last place, or half of one), are 2.2 for `exp`, 4.4 for `ln`,
/// 2.9 for `sin` and `cos`, 7 for `tan`, 5 for `atan`, 4.1 for `sinh`, 3.6 for `cosh` and 6.7 for
/// `tanh`. These relative widths hold near zeros too, since nothing cancels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigorous;
