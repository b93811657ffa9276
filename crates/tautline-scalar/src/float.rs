//! `f64` as a [`Scalar`]: values, and nothing else.

use crate::Scalar;

impl Scalar for f64 {
    fn constant(value: f64) -> f64 {
        value
    }

    fn sqr(self) -> f64 {
        self * self
    }

    fn powi(self, n: i32) -> f64 {
        f64::powi(self, n)
    }

    fn recip(self) -> f64 {
        1.0 / self
    }

    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    fn exp(self) -> f64 {
        f64::exp(self)
    }

    fn ln(self) -> f64 {
        f64::ln(self)
    }

    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }

    fn tan(self) -> f64 {
        f64::tan(self)
    }

    fn atan(self) -> f64 {
        f64::atan(self)
    }

    fn sinh_cosh(self) -> (f64, f64) {
        (f64::sinh(self), f64::cosh(self))
    }

    fn tanh(self) -> f64 {
        f64::tanh(self)
    }

    // The four below drop the half that is not asked for.

    fn sin(self) -> f64 {
        f64::sin(self)
    }

    fn cos(self) -> f64 {
        f64::cos(self)
    }

    fn sinh(self) -> f64 {
        f64::sinh(self)
    }

    fn cosh(self) -> f64 {
        f64::cosh(self)
    }
}
