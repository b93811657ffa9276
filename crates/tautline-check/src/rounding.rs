//! Sums, products and roots of doubles, rounded down or up.
//!
//! They are ends of intervals. If an argument is NaN or infinite, the result is NaN, which fails
//! every comparison.

use tautline_scalar::{Interval, Scalar};

pub(crate) fn add_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) + Interval::point(b)).lo()
}

pub(crate) fn add_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) + Interval::point(b)).hi()
}

pub(crate) fn mul_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) * Interval::point(b)).lo()
}

pub(crate) fn mul_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) * Interval::point(b)).hi()
}

pub(crate) fn div_down(a: f64, b: f64) -> f64 {
    (Interval::point(a) / Interval::point(b)).lo()
}

pub(crate) fn div_up(a: f64, b: f64) -> f64 {
    (Interval::point(a) / Interval::point(b)).hi()
}

pub(crate) fn sqrt_down(a: f64) -> f64 {
    Interval::point(a).sqrt().lo()
}

pub(crate) fn sqrt_up(a: f64) -> f64 {
    Interval::point(a).sqrt().hi()
}
