//! The exponential function.

use std::f64::consts::LOG2_E;

use super::{ROUND, all};

/// The range in which the value and all intermediate results are normal numbers.
const RANGE: [f64; 2] = [-708.0, 709.0];

/// `ln 2` in two parts. The first part ends in so many zero bits that its products with exponents
/// are exact.
const LN_2: [f64; 2] = [0.693_145_751_953_125, 1.428_606_820_309_417_232_12e-6];

/// Fills `y` with `eˣ`.
#[inline(always)]
pub(crate) fn exp<const B: usize>(y: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        y[i] = lane(x[i]);
    }
    if !all(x, is_within) {
        for i in 0..B {
            if !is_within(x[i]) {
                y[i] = x[i].exp();
            }
        }
    }
}

#[inline(always)]
fn is_within(x: f64) -> bool {
    (RANGE[0]..=RANGE[1]).contains(&x)
}

/// Returns `eˣ` for `x` in the range. The result is meaningless elsewhere.
#[inline(always)]
pub(super) fn lane(x: f64) -> f64 {
    let shifted = x * LOG2_E + ROUND;
    let n = shifted - ROUND;
    let r = (x - n * LN_2[0]) - n * LN_2[1];
    // Taylor's polynomial of degree 13: |r| ≤ ln 2/2, so that r¹⁴/14! is 4e−18.
    let of = |k: usize| const { RECIPROCALS }[k];
    let (r2, r4) = (r * r, (r * r) * (r * r));
    let high = ((of(13) * r + of(12)) * r2 + (of(11) * r + of(10))) * r4
        + ((of(9) * r + of(8)) * r2 + (of(7) * r + of(6)));
    let low = (of(5) * r + of(4)) * r2 + (of(3) * r + of(2));
    // 1 + r + r²(…), where small terms are added first.
    let power = 1.0 + (r + r2 * (low + r4 * high));
    // The last bits of `shifted` are n. Shifted into the exponent, they make 2ⁿ.
    let exponent = shifted.to_bits().wrapping_add(1023) << 52;
    power * f64::from_bits(exponent)
}

/// The numbers `1/k!`.
const RECIPROCALS: [f64; 14] = {
    let mut all = [1.0; 14];
    let (mut k, mut factorial) = (1, 1.0);
    while k < 14 {
        factorial *= k as f64;
        all[k] = 1.0 / factorial;
        k += 1;
    }
    all
};
