//! `Fast`: elementary functions of a library that rounds them correctly.

use super::{Enclosure, kernel::Kernel};

/// An interval whose elementary functions trust the library `pxfm`.
pub type FastInterval = Enclosure<Fast>;

/// The functions of `pxfm`, widened by one double on either side.
///
/// The library states an error of half a unit in the last place, a claim and not a proof;
/// a whole neighbour on either side holds even if the error is up to one unit. Values that a
/// function takes exactly, and the bounds it never crosses, are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fast;

/// The neighbours of `y`, but nothing outside `[least, greatest]`.
#[inline]
fn around(y: f64, least: f64, greatest: f64) -> (f64, f64) {
    if y.is_nan() {
        return (least, greatest);
    }
    (y.next_down().clamp(least, greatest), y.next_up().clamp(least, greatest))
}

/// As [`around`], for a function whose value at zero is `at_zero` exactly.
#[inline]
fn with_exact(x: f64, at_zero: f64, y: f64, least: f64, greatest: f64) -> (f64, f64) {
    if x == 0.0 { (at_zero, at_zero) } else { around(y, least, greatest) }
}

const MAX: f64 = f64::INFINITY;
const MIN: f64 = f64::NEG_INFINITY;

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
    #[inline]
    fn sin(x: f64) -> (f64, f64) {
        with_exact(x, 0.0, pxfm::f_sin(x), -1.0, 1.0)
    }
    #[inline]
    fn cos(x: f64) -> (f64, f64) {
        with_exact(x, 1.0, pxfm::f_cos(x), -1.0, 1.0)
    }
    #[inline]
    fn tan(x: f64) -> (f64, f64) {
        with_exact(x, 0.0, pxfm::f_tan(x), MIN, MAX)
    }
    #[inline]
    fn atan(x: f64) -> (f64, f64) {
        with_exact(x, 0.0, pxfm::f_atan(x), MIN, MAX)
    }
    #[inline]
    fn sinh(x: f64) -> (f64, f64) {
        with_exact(x, 0.0, pxfm::f_sinh(x), MIN, MAX)
    }
    #[inline]
    fn cosh(x: f64) -> (f64, f64) {
        with_exact(x, 1.0, pxfm::f_cosh(x), 1.0, MAX)
    }
    #[inline]
    fn tanh(x: f64) -> (f64, f64) {
        with_exact(x, 0.0, pxfm::f_tanh(x), -1.0, 1.0)
    }
}
