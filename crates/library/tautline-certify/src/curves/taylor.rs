//! `Taylor`: a function of one variable, represented by the first coefficients of its power series.

#[cfg(test)]
mod tests;

use std::{
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::Arc,
};

use num_traits::{One, Zero};
use tautline_scalar::{Scalar, Table};

/// The coefficients `aₖ = f⁽ᵏ⁾/k!`, `k < M`, of a function `f` of one variable.
///
/// Over intervals, the coefficients enclose the exact coefficients at every point of the variable's
/// interval. Each operation uses the recurrence that follows from its differential equation, so a
/// product costs `M (M + 1)/2` multiplications. A jet of a jet needs three times as many at order
/// four, and its bounds are wider, since it computes mixed derivatives twice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Taylor<T, const M: usize>([T; M]);

impl<T: Scalar, const M: usize> Taylor<T, M> {
    /// Returns the function `value + slope u` at `u = 0`.
    pub(super) fn line(value: T, slope: T) -> Self {
        let mut coefficients = [T::zero(); M];
        coefficients[0] = value;
        if M > 1 {
            coefficients[1] = slope;
        }
        Self(coefficients)
    }

    /// Returns the sum of the terms, each multiplied by its constant factor.
    pub(super) fn combination(terms: impl Iterator<Item = (Self, T)>) -> Self {
        let mut sum = Self::zero();
        for (term, factor) in terms {
            for k in 0..M {
                sum.0[k] += term.0[k] * factor;
            }
        }
        sum
    }

    /// Returns `aₖ`.
    pub(super) fn coefficient(&self, k: usize) -> T {
        self.0[k]
    }

    fn constant_part(value: T) -> Self {
        Self::line(value, T::zero())
    }

    /// Computes each coefficient from those before it.
    fn recursive(first: T, next: impl Fn(usize, &[T; M]) -> T) -> Self {
        let mut b = [T::zero(); M];
        b[0] = first;
        for k in 1..M {
            b[k] = next(k, &b);
        }
        Self(b)
    }

    /// Returns the sum of `aᵢ bₖ₋ᵢ` over `1 ≤ i ≤ k`.
    fn convolution(a: &[T; M], b: &[T; M], k: usize) -> T {
        // Here and below, the sum starts with the first term, to save an addition.
        (2..=k).fold(a[1] * b[k - 1], |sum, i| sum + a[i] * b[k - i])
    }

    /// Returns `i aᵢ`, the coefficients of `u a′`.
    fn slopes(a: &[T; M]) -> [T; M] {
        std::array::from_fn(|i| if i < 2 { a[i] } else { a[i] * i as f64 })
    }

    /// Returns coefficient `k` of `f`, where `f′ = a′ w`, given the slopes of `a`:
    /// `(1/k) Σ i aᵢ wₖ₋ᵢ`.
    fn integral(slopes: &[T; M], w: &[T; M], k: usize) -> T {
        let sum = Self::convolution(slopes, w, k);
        if k == 1 { sum } else { sum / k as f64 }
    }

    /// Returns coefficient `k` of `f²`. Squares are taken with `sqr`, so that intervals of squares
    /// are not negative.
    fn square(a: &[T; M], k: usize) -> T {
        if k == 0 {
            return a[0].sqr();
        }
        let half = k.div_ceil(2);
        let pairs = (1..half).fold(a[0] * a[k], |sum, i| sum + a[i] * a[k - i]) * 2.0;
        if k.is_multiple_of(2) { pairs + a[k / 2].sqr() } else { pairs }
    }

    /// Returns `f` and `g` with `f′ = a′ g` and `g′ = ± a′ f`, given their values.
    fn coupled(self, (f0, g0): (T, T), sign: f64) -> (Self, Self) {
        let slopes = Self::slopes(&self.0);
        let (mut f, mut g) = ([T::zero(); M], [T::zero(); M]);
        (f[0], g[0]) = (f0, g0);
        for k in 1..M {
            (f[k], g[k]) = (Self::integral(&slopes, &g, k), Self::integral(&slopes, &f, k) * sign);
        }
        (Self(f), Self(g))
    }

    /// Returns `f` with `f′ = a′ w`, where `w = w₀ ± f²` up to a constant, given the values of
    /// both.
    fn quadratic(self, f0: T, w0: T, sign: f64) -> Self {
        let slopes = Self::slopes(&self.0);
        let (mut f, mut w) = ([T::zero(); M], [T::zero(); M]);
        (f[0], w[0]) = (f0, w0);
        for k in 1..M {
            f[k] = Self::integral(&slopes, &w, k);
            w[k] = Self::square(&f, k) * sign;
        }
        Self(f)
    }
}

impl<T: Scalar, const M: usize> Neg for Taylor<T, M> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|a| -a))
    }
}

impl<T: Scalar, const M: usize> Add for Taylor<T, M> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<T: Scalar, const M: usize> Sub for Taylor<T, M> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<T: Scalar, const M: usize> Mul for Taylor<T, M> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| {
            (1..=k).fold(self.0[0] * other.0[k], |sum, i| sum + self.0[i] * other.0[k - i])
        }))
    }
}

impl<T: Scalar, const M: usize> Div for Taylor<T, M> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        // The recurrence follows from q b = a.
        Self::recursive(a[0] / b[0], |k, q| (a[k] - Self::convolution(&b, q, k)) / b[0])
    }
}

/// Operators with a number, and assignment operators.
macro_rules! operators {
    ($($Op:ident $op:ident $Assign:ident $assign:ident |$f:ident, $c:ident| $value:expr;)*) => {$(
        impl<T: Scalar, const M: usize> $Op<f64> for Taylor<T, M> {
            type Output = Self;
            fn $op(self, $c: f64) -> Self {
                let $f = self.0;
                Self($value)
            }
        }
        impl<T: Scalar, const M: usize> $Assign for Taylor<T, M> {
            fn $assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign |f, c| with_first(f, f[0] + c);
    Sub sub SubAssign sub_assign |f, c| with_first(f, f[0] + -c);
    Mul mul MulAssign mul_assign |f, c| f.map(|a| a * c);
    Div div DivAssign div_assign |f, c| f.map(|a| a / c);
}

/// Returns the coefficients with another constant one.
fn with_first<T, const M: usize>(mut coefficients: [T; M], first: T) -> [T; M] {
    coefficients[0] = first;
    coefficients
}

tautline_scalar::f64_on_the_left!([T: Scalar, const M: usize] Taylor<T, M>);

impl<T: Scalar, const M: usize> Zero for Taylor<T, M> {
    fn zero() -> Self {
        Self([T::zero(); M])
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<T: Scalar, const M: usize> One for Taylor<T, M> {
    fn one() -> Self {
        Self::constant_part(T::one())
    }
}

impl<T: Scalar, const M: usize> Scalar for Taylor<T, M> {
    fn constant(value: f64) -> Self {
        Self::constant_part(T::constant(value))
    }

    /// The sum of `∂^α F(u₀) Π (uₐ − uₐ₀)^αₐ / αₐ!` over all `|α| < M`. A term adds nothing to the
    /// coefficients below `|α|`, which stay defined if this derivative has no bounds.
    fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[Self]) -> Self {
        if u.len() > 3 {
            return Self([T::constant(f64::NAN); M]);
        }
        let axes = u.len();
        let (mut at, mut steps) = ([T::zero(); 3], [Self::zero(); 3]);
        for axis in 0..axes {
            (at[axis], steps[axis]) = (u[axis].0[0], u[axis]);
            steps[axis].0[0] = T::zero();
        }
        let most = |axis: usize, left: usize| if axis < axes { left } else { 0 };
        let mut sum = Self::zero();
        let mut of_first = Self::one();
        for a in 0..=most(0, M - 1) {
            let mut of_both = of_first;
            for b in 0..=most(1, M - 1 - a) {
                let mut term = of_both;
                for c in 0..=most(2, M - 1 - a - b) {
                    let raised = [a, b, c].map(|more| more as u8);
                    let orders = [0, 1, 2].map(|axis| orders[axis].saturating_add(raised[axis]));
                    let derivative = T::tabulated(table, orders, &at[..axes]);
                    for k in a + b + c..M {
                        sum.0[k] += term.0[k] * derivative;
                    }
                    term = term * steps[2] / (c + 1) as f64;
                }
                of_both = of_both * steps[1] / (b + 1) as f64;
            }
            of_first = of_first * steps[0] / (a + 1) as f64;
        }
        sum
    }

    fn sqr(self) -> Self {
        Self(std::array::from_fn(|k| Self::square(&self.0, k)))
    }

    fn powi(self, n: i32) -> Self {
        match n {
            // Not the constant 1: an undefined argument must stay undefined.
            0 => Self::constant_part(self.0[0].powi(0)),
            1 => self,
            // One factor is split off first, since −n may overflow.
            ..0 => self.recip() * self.recip().powi(-(n + 1)),
            _ if n % 2 == 0 => self.powi(n / 2).sqr(),
            _ => self.powi(n - 1) * self,
        }
    }

    fn recip(self) -> Self {
        let a = self.0;
        let first = a[0].recip();
        Self::recursive(first, |k, b| -(Self::convolution(&a, b, k) * first))
    }

    fn sqrt(self) -> Self {
        let a = self.0;
        let root = a[0].sqrt();
        // From 2 b₀ bₖ = aₖ − Σ bᵢ bₖ₋ᵢ over 0 < i < k. The sum is the square with b₀ and bₖ set to
        // zero.
        Self::recursive(root, |k, b| {
            let mut inner = *b;
            inner[0] = T::zero();
            (a[k] - Self::square(&inner, k)) / (root * 2.0)
        })
    }

    fn exp(self) -> Self {
        let slopes = Self::slopes(&self.0);
        Self::recursive(self.0[0].exp(), |k, b| Self::integral(&slopes, b, k))
    }

    fn ln(self) -> Self {
        let a = self.0;
        // From b′ a = a′. The logarithm of a negative number is undefined, though its derivative is
        // not.
        let inside = a[0].ln() * 0.0;
        Self::recursive(a[0].ln(), |k, b| {
            let earlier =
                (1..k).fold(T::zero(), |sum, i| sum + b[i] * a[k - i] * i as f64) / k as f64;
            (a[k] - earlier) / a[0] + inside
        })
    }

    fn sin_cos(self) -> (Self, Self) {
        self.coupled(self.0[0].sin_cos(), -1.0)
    }

    fn tan(self) -> Self {
        let t = self.0[0].tan();
        self.quadratic(t, t.sqr() + 1.0, 1.0)
    }

    fn atan(self) -> Self {
        let a = self.0;
        let w = (self.sqr() + 1.0).0;
        // The recurrence follows from b′ (1 + a²) = a′.
        Self::recursive(a[0].atan(), |k, b| {
            let earlier =
                (1..k).fold(T::zero(), |sum, i| sum + b[i] * w[k - i] * i as f64) / k as f64;
            (a[k] - earlier) / w[0]
        })
    }

    fn sinh_cosh(self) -> (Self, Self) {
        self.coupled(self.0[0].sinh_cosh(), 1.0)
    }

    fn tanh(self) -> Self {
        let a = self.0[0];
        // The slope is 1/cosh², since 1 − tanh² cancels where tanh is close to ±1.
        self.quadratic(a.tanh(), a.cosh().sqr().recip(), -1.0)
    }
}
