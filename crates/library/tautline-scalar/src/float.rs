//! `f64` as a [`Scalar`]: values only.

use std::sync::Arc;

use crate::{Scalar, Table};

macro_rules! inherent {
    ($($function:ident)*) => {$(
        fn $function(self) -> f64 {
            f64::$function(self)
        }
    )*};
}

impl Scalar for f64 {
    inherent!(sqrt exp ln sin cos tan atan sinh cosh tanh);

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

    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }

    fn sinh_cosh(self) -> (f64, f64) {
        (f64::sinh(self), f64::cosh(self))
    }

    fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[f64]) -> f64 {
        if u.len() == table.axes() { table.value(u, orders) } else { f64::NAN }
    }
}
