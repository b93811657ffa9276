//! `Precise`: a value in high precision, as a [`Scalar`].

use std::{
    cell::RefCell,
    fmt,
    ops::{Add, Div, Mul, Neg, Sub},
};

use num_traits::One;
use tautline_scalar::Scalar;

use super::ball::{Ball, P, Value};
use crate::reference::Reference;

thread_local! {
    /// All values since the last [`Precise::forget_all`].
    static VALUES: RefCell<Vec<Value>> = RefCell::default();
}

/// The index of a value of this thread, since a [`Scalar`] is [`Copy`].
#[derive(Clone, Copy)]
pub(crate) struct Precise(u32);

impl Precise {
    fn new(value: Value) -> Self {
        VALUES.with_borrow_mut(|values| {
            values.push(value);
            Self(u32::try_from(values.len() - 1).expect("fewer than 2³² values"))
        })
    }

    /// Frees the memory. No earlier number may be used again.
    pub(crate) fn forget_all() {
        VALUES.with_borrow_mut(Vec::clear);
    }

    pub(crate) fn value(self) -> Value {
        VALUES.with_borrow(|values| values[self.0 as usize].clone())
    }

    /// Returns the number `lo + t (hi − lo)`, to 192 bits. It is hardly ever a double.
    ///
    /// Needs: `lo ≤ hi`, `0 ≤ t ≤ 1`.
    pub(crate) fn between(lo: f64, hi: f64, t: f64) -> Self {
        const EVEN: astro_float::RoundingMode = astro_float::RoundingMode::ToEven;
        let (lo, hi) = (Reference::big(lo), Reference::big(hi));
        let mut x = lo.add(&hi.sub(&lo, P, EVEN).mul(&Reference::big(t), P, EVEN), P, EVEN);
        x.set_inexact(false);
        Self::new(Value::Within(Ball::exact(x.max(&lo).min(&hi))))
    }

    fn map(self, f: impl FnOnce(&Ball) -> Value) -> Self {
        Self::new(self.value().then(f))
    }

    fn map_two(self, f: impl FnOnce(&Ball) -> (Value, Value)) -> (Self, Self) {
        let (a, b) = match self.value() {
            Value::Within(x) => f(&x),
            other => (other.clone(), other),
        };
        (Self::new(a), Self::new(b))
    }

    fn zip(self, other: Self, f: impl FnOnce(&Ball, &Ball) -> Value) -> Self {
        Self::new(self.value().with(&other.value(), f))
    }
}

impl fmt::Debug for Precise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.value() {
            Value::Within(x) => write!(f, "{} ± {}", x.centre, x.radius),
            Value::Undefined => write!(f, "undefined"),
            Value::Unknown => write!(f, "unknown"),
        }
    }
}

/// Two numbers are equal if both are known to be the same number.
impl PartialEq for Precise {
    fn eq(&self, other: &Self) -> bool {
        match (*self - *other).value() {
            Value::Within(difference) => difference.is_zero(),
            _ => false,
        }
    }
}

impl Neg for Precise {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|x| Value::Within(x.negative()))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident: $of:expr;)*) => {$(
        impl $operator for Precise {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.zip(other, $of)
            }
        }
    )*};
}

operators! {
    Add add: Ball::add;
    Sub sub: |x, y| x.add(&y.negative());
    Mul mul: Ball::mul;
    Div div: Ball::div;
}

tautline_scalar::operators_follow!([] Precise);

macro_rules! by_ball {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            self.map(Ball::$function)
        }
    )*};
}

impl Scalar for Precise {
    by_ball!(sqrt exp ln atan);

    /// The result is undefined unless `value` is finite.
    fn constant(value: f64) -> Self {
        Self::new(if value.is_finite() {
            Value::Within(Ball::exact(Reference::big(value)))
        } else {
            Value::Undefined
        })
    }

    fn sqr(self) -> Self {
        self * self
    }

    /// Computes the power by squaring. It is undefined for `n < 0` at zero, and if `x` is, even for
    /// `n = 0`.
    fn powi(self, n: i32) -> Self {
        let mut power = self.map(|_| Value::Within(Ball::exact(Reference::big(1.0))));
        for place in (0..n.unsigned_abs().checked_ilog2().map_or(0, |k| k + 1)).rev() {
            power = power * power;
            if n.unsigned_abs() >> place & 1 == 1 {
                power *= self;
            }
        }
        if n < 0 { power.recip() } else { power }
    }

    fn recip(self) -> Self {
        Self::one() / self
    }

    fn sin_cos(self) -> (Self, Self) {
        self.map_two(Ball::sin_cos)
    }

    fn tan(self) -> Self {
        let (s, c) = self.sin_cos();
        s / c
    }

    fn sinh_cosh(self) -> (Self, Self) {
        self.map_two(Ball::sinh_cosh)
    }

    fn tanh(self) -> Self {
        let (s, c) = self.sinh_cosh();
        s / c
    }
}
