//! The reference of the unit tests: `astro-float` at 320 bits.

use astro_float::{BigFloat, Consts, RoundingMode};

/// The precision in bits.
pub(super) const P: usize = 320;
pub(super) const RM: RoundingMode = RoundingMode::None;

pub(super) fn big(x: f64) -> BigFloat {
    BigFloat::from_f64(x, P)
}

/// Returns whether `a ≤ b`; false for NaN.
pub(super) fn at_most(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order <= 0)
}

pub(super) fn constants() -> Consts {
    Consts::new().expect("memory for the constants")
}

pub(super) fn half_pi() -> BigFloat {
    constants().pi(P, RM).mul(&big(0.5), P, RM)
}

/// Returns the distance between `value` and the exact sum of `parts`.
pub(super) fn error_of_sum(parts: &[f64], value: &BigFloat) -> BigFloat {
    let sum = parts.iter().fold(big(0.0), |sum, &part| sum.add(&big(part), P, RM));
    value.sub(&sum, P, RM).abs()
}
