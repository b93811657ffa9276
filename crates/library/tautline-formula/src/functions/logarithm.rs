//! The natural logarithm.

use super::all;

/// `ln 2` in two parts. Products of the first part with exponents are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238_164_90e-1, 1.908_214_929_270_587_700_02e-10];

/// Coefficients of `R` in `ln((1 + s)/(1 − s)) = 2s + s R(s²)` for `|s| ≤ 3 − 2√2` (fdlibm's
/// `log`).
const SERIES: [f64; 7] = [
    6.666_666_666_666_735_130e-1,
    3.999_999_999_940_941_908e-1,
    2.857_142_874_366_239_149e-1,
    2.222_219_843_214_978_396e-1,
    1.818_357_216_161_805_012e-1,
    1.531_383_769_920_937_332e-1,
    1.479_819_860_511_658_591e-1,
];

/// Fills `y` with `ln x`.
#[inline(always)]
pub(crate) fn ln<const B: usize>(y: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        y[i] = lane(x[i]);
    }
    if !all(x, is_within) {
        for i in 0..B {
            if !is_within(x[i]) {
                y[i] = x[i].ln();
            }
        }
    }
}

#[inline(always)]
fn is_within(x: f64) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&x)
}

#[inline(always)]
fn lane(x: f64) -> f64 {
    // x = 2ᵏ (1 + f) with 1 + f between √½ and √2. After the bits of √½ are subtracted, the
    // exponent is k.
    const ROOT: u64 = 0x3fe6_a09e_667f_3bcd;
    let above = x.to_bits().wrapping_sub(ROOT);
    // k + 2¹¹ is an integer below 2¹², which is converted through the bits of 2⁵².
    const MAGIC: f64 = 4_503_599_627_370_496.0;
    let shifted = above.wrapping_add(1 << 63) >> 52;
    let k = f64::from_bits(shifted | MAGIC.to_bits()) - (MAGIC + 2048.0);
    let f = f64::from_bits((above & ((1 << 52) - 1)).wrapping_add(ROOT)) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let [l1, l2, l3, l4, l5, l6, l7] = SERIES;
    let r = w * (l2 + w * (l4 + w * l6)) + z * (l1 + w * (l3 + w * (l5 + w * l7)));
    let half_square = 0.5 * f * f;
    k * LN_2[0] - ((half_square - (s * (half_square + r) + k * LN_2[1])) - f)
}
