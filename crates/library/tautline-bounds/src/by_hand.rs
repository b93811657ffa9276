//! Helpers for the unit tests that compare bounds with values computed by hand.

use std::num::NonZeroUsize;

use crate::Constants;

pub(crate) fn n(n: usize) -> NonZeroUsize {
    NonZeroUsize::new(n).expect("positive")
}

pub(crate) fn constants(c1: f64, c2: f64, l_h: f64) -> Constants {
    Constants::new(c1, c2, l_h).expect("in order")
}

pub(crate) fn with_m_h(c1: f64, c2: f64, l_h: f64, m_h: f64) -> Constants {
    constants(c1, c2, l_h).with_m_h(m_h).expect("nonnegative")
}

/// Fails unless `value` is within the relative `tolerance`; a bound that is `None` fails too.
#[track_caller]
pub(crate) fn close(value: impl Into<Option<f64>>, expected: f64, tolerance: f64) {
    let value = value.into().expect("M_H is known");
    assert!((value / expected - 1.0).abs() < tolerance, "{value} is not {expected}");
}
