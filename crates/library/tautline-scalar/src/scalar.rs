//! `Scalar`: the operations that a formula may use.

use std::{
    fmt::Debug,
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::Arc,
};

use num_traits::{One, Zero};

use crate::{Table, f64_on_the_left::Beside};

/// A number in which a smooth formula can be evaluated.
///
/// A formula is a function generic over `S: Scalar`, and reads as in mathematics. An `f64` may
/// appear on either side of an operator: `2.0 * x` compiles, but `2 * x` does not.
///
/// ```
/// use tautline_scalar::Scalar;
///
/// fn formula<S: Scalar>(x: S, y: S) -> S {
///     1.0 + 2.0 * x - (2.0 - x.cos()).sqr() / (3.0 + y) + 2.0 / y.exp()
/// }
/// assert_eq!(formula(0.0, 0.0), 1.0 - 1.0 / 3.0 + 2.0);
/// ```
///
/// To turn a number into a scalar, write [`S::constant(2.0)`](Scalar::constant), `S::zero()` or
/// `S::one()`.
///
/// # Laws
///
/// Every operation is smooth on its domain. Outside the domain (`ln` of a negative number, division
/// by zero) the result is NaN or infinite, and so is everything computed from it. No operation
/// panics.
///
/// For a number type of your own, [`operators_follow!`](crate::operators_follow) writes most of the
/// operators.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    // A number on the left, by value and by reference. With only one of these bounds, type
    // inference would resolve every `f64 - …` in a formula to it.
    + Beside<f64, Is = f64>
    + Beside<
        f64,
        Is: Add<Self, Output = Self>
                + Sub<Self, Output = Self>
                + Mul<Self, Output = Self>
                + Div<Self, Output = Self>
                + for<'x> Add<&'x Self, Output = Self>
                + for<'x> Sub<&'x Self, Output = Self>
                + for<'x> Mul<&'x Self, Output = Self>
                + for<'x> Div<&'x Self, Output = Self>,
    >
{
    /// Returns the number `value`, exactly.
    fn constant(value: f64) -> Self;

    /// Returns `x²`.
    ///
    /// For intervals this is tighter than `x * x`: the square of an interval around zero has no
    /// negative part.
    #[must_use]
    fn sqr(self) -> Self;

    /// Returns `xⁿ`, which is `1` for `n = 0`, and `1 / x⁻ⁿ` for `n < 0`.
    #[must_use]
    fn powi(self, n: i32) -> Self;

    /// Returns `1 / x`.
    #[must_use]
    fn recip(self) -> Self;

    /// Returns `√x`; NaN for `x < 0`. The root is not differentiable at `0`.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Returns `eˣ`.
    #[must_use]
    fn exp(self) -> Self;

    /// Returns the natural logarithm of `x`; NaN for `x < 0`.
    #[must_use]
    fn ln(self) -> Self;

    /// Returns `(sin x, cos x)`, with `x` in radians, at less than the cost of two calls.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// Returns `tan x`, with `x` in radians.
    #[must_use]
    fn tan(self) -> Self;

    /// Returns the angle in `(−π/2, π/2)` whose tangent is `x`.
    #[must_use]
    fn atan(self) -> Self;

    /// Returns `(sinh x, cosh x)`, at less than the cost of two calls.
    #[must_use]
    fn sinh_cosh(self) -> (Self, Self);

    /// Returns `tanh x`.
    #[must_use]
    fn tanh(self) -> Self;

    /// Returns the partial derivative of a table at the arguments `u`, one for each axis; `orders` are
    /// its orders along the axes, all 0 for the value. NaN for a wrong number of arguments, and in a
    /// number type that does not know tables.
    #[must_use]
    fn tabulated(_table: &Arc<dyn Table>, _orders: [u8; 3], _u: &[Self]) -> Self {
        Self::constant(f64::NAN)
    }

    /// Returns `sin x`, with `x` in radians.
    #[must_use]
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Returns `cos x`, with `x` in radians.
    #[must_use]
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// Returns `sinh x`.
    #[must_use]
    #[inline]
    fn sinh(self) -> Self {
        self.sinh_cosh().0
    }

    /// Returns `cosh x`.
    #[must_use]
    #[inline]
    fn cosh(self) -> Self {
        self.sinh_cosh().1
    }
}
