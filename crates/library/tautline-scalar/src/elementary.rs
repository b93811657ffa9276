//! The elementary functions of [`Scalar`] with their derivatives, for chain rules.
//!
//! Each function returns `[f(x), f′(x), f″(x)]`. The value is that of the method of [`Scalar`] with the
//! same name.

use crate::Scalar;

/// Returns `x²` and its derivatives.
#[must_use]
#[inline]
pub fn sqr<T: Scalar>(x: T) -> [T; 3] {
    [x.sqr(), x * 2.0, T::constant(2.0)]
}

/// Returns `xⁿ` and its derivatives.
#[must_use]
#[inline]
pub fn powi<T: Scalar>(x: T, n: i32) -> [T; 3] {
    let k = f64::from(n);
    match n {
        // The general case would compute n xⁿ⁻¹ as 0 · ∞ at x = 0.
        0 => [x.powi(0), T::zero(), T::zero()],
        1 => [x, T::one(), T::zero()],
        2 => sqr(x),
        // Here n − 2 overflows.
        ..=-2_147_483_647 => {
            let power = x.powi(n);
            let first = power / x * k;
            [power, first, first / x * (k - 1.0)]
        }
        // Here n (n − 1) has at most 53 bits.
        -67_108_863..=67_108_864 => [x.powi(n), x.powi(n - 1) * k, x.powi(n - 2) * (k * (k - 1.0))],
        // Here it is rounded, so intervals must enclose it.
        _ => [x.powi(n), x.powi(n - 1) * k, x.powi(n - 2) * (T::constant(k) * (k - 1.0))],
    }
}

/// Returns `1/x` and its derivatives.
#[must_use]
#[inline]
pub fn recip<T: Scalar>(x: T) -> [T; 3] {
    let r = x.recip();
    [r, -r.sqr(), r.sqr() * r * 2.0]
}

/// Returns `√x` and its derivatives.
#[must_use]
#[inline]
pub fn sqrt<T: Scalar>(x: T) -> [T; 3] {
    let s = x.sqrt();
    let first = s.recip() * 0.5;
    [s, first, -first / x * 0.5]
}

/// Returns `eˣ` and its derivatives.
#[must_use]
#[inline]
pub fn exp<T: Scalar>(x: T) -> [T; 3] {
    let e = x.exp();
    [e, e, e]
}

/// Returns the natural logarithm of `x` and its derivatives.
#[must_use]
#[inline]
pub fn ln<T: Scalar>(x: T) -> [T; 3] {
    let first = x.recip();
    // ln x is NaN for x < 0, though 1/x is not. The derivatives must be NaN too.
    let inside = x.ln() * 0.0;
    [x.ln(), first + inside, -first.sqr() + inside]
}

/// Returns `sin x` and `cos x`, each with its derivatives.
#[must_use]
#[inline]
pub fn sin_cos<T: Scalar>(x: T) -> [[T; 3]; 2] {
    let (s, c) = x.sin_cos();
    [[s, c, -s], [c, -s, -c]]
}

/// Returns `tan x` and its derivatives.
#[must_use]
#[inline]
pub fn tan<T: Scalar>(x: T) -> [T; 3] {
    let t = x.tan();
    let first = t.sqr() + 1.0;
    [t, first, t * first * 2.0]
}

/// Returns `arctan x` and its derivatives.
#[must_use]
#[inline]
pub fn atan<T: Scalar>(x: T) -> [T; 3] {
    let first = (x.sqr() + 1.0).recip();
    [x.atan(), first, -x * first.sqr() * 2.0]
}

/// Returns `sinh x` and `cosh x`, each with its derivatives.
#[must_use]
#[inline]
pub fn sinh_cosh<T: Scalar>(x: T) -> [[T; 3]; 2] {
    let (s, c) = x.sinh_cosh();
    [[s, c, s], [c, s, c]]
}

/// Returns `tanh x` and its derivatives.
#[must_use]
#[inline]
pub fn tanh<T: Scalar>(x: T) -> [T; 3] {
    let t = x.tanh();
    // The derivative is 1/cosh², not 1 − tanh², which cancels where tanh is close to ±1.
    let first = x.cosh().sqr().recip();
    [t, first, -t * first * 2.0]
}
