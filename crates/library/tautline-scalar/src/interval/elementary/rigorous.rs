//! The rigorous kernel, which takes each function from the file of its name.

use super::{arctangent, circular, exponential, hyperbolic, logarithm};
use crate::interval::{Kernel, Rigorous};

macro_rules! by_module {
    ($($module:ident::$function:ident;)*) => {$(
        #[inline]
        fn $function(x: f64) -> (f64, f64) {
            $module::$function(x)
        }
    )*};
}

impl Kernel for Rigorous {
    by_module! {
        exponential::exp;
        logarithm::ln;
        circular::sin;
        circular::cos;
        circular::tan;
        arctangent::atan;
        hyperbolic::sinh;
        hyperbolic::cosh;
        hyperbolic::tanh;
    }

    #[inline]
    fn sin_cos(x: f64) -> ((f64, f64), (f64, f64)) {
        circular::sin_cos(x)
    }
}
