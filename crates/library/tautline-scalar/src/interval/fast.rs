//! `Fast`: elementary functions from a library that claims correct rounding.

use super::{Enclosure, kernel::Kernel};

/// An interval whose elementary functions trust the library `pxfm`.
pub type FastInterval = Enclosure<Fast>;

/// The functions of `pxfm`, with their results widened by one double on either side.
///
/// The library claims, without proof, an error of half a unit in the last place. One double on
/// either side allows for a whole unit. Exact values stay exact, and bounds such as `|sin x| ≤ 1`
/// hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fast;

/// Returns the neighbours of `y`, clamped to `[least, greatest]`.
#[inline]
fn around(y: f64, least: f64, greatest: f64) -> (f64, f64) {
    if y.is_nan() {
        return (least, greatest);
    }
    (y.next_down().clamp(least, greatest), y.next_up().clamp(least, greatest))
}

/// Does the same as [`around`], for a function with the exact value `at_zero` at zero.
#[inline]
fn with_exact(x: f64, at_zero: f64, y: f64, least: f64, greatest: f64) -> (f64, f64) {
    if x == 0.0 { (at_zero, at_zero) } else { around(y, least, greatest) }
}

const MAX: f64 = f64::INFINITY;
const MIN: f64 = f64::NEG_INFINITY;

macro_rules! by_pxfm {
    ($($function:ident: $by:ident, $at_zero:literal, [$least:expr, $greatest:expr];)*) => {$(
        #[inline]
        fn $function(x: f64) -> (f64, f64) {
            with_exact(x, $at_zero, pxfm::$by(x), $least, $greatest)
        }
    )*};
}

impl Kernel for Fast {
    #[inline]
    fn exp(x: f64) -> (f64, f64) {
        if x == f64::NEG_INFINITY {
            return (0.0, 0.0);
        }
        with_exact(x, 1.0, pxfm::f_exp(x), 0.0, MAX)
    }
    #[inline]
    fn ln(x: f64) -> (f64, f64) {
        if x == 1.0 { (0.0, 0.0) } else { around(pxfm::f_log(x), MIN, MAX) }
    }
    #[inline]
    fn sin_cos(x: f64) -> ((f64, f64), (f64, f64)) {
        let (s, c) = pxfm::f_sincos(x);
        (with_exact(x, 0.0, s, -1.0, 1.0), with_exact(x, 1.0, c, -1.0, 1.0))
    }
    by_pxfm! {
        sin: f_sin, 0.0, [-1.0, 1.0];
        cos: f_cos, 1.0, [-1.0, 1.0];
        tan: f_tan, 0.0, [MIN, MAX];
        atan: f_atan, 0.0, [MIN, MAX];
        sinh: f_sinh, 0.0, [MIN, MAX];
        cosh: f_cosh, 1.0, [1.0, MAX];
        tanh: f_tanh, 0.0, [-1.0, 1.0];
    }
}
