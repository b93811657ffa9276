//! `π/2`, `ln 2` and the arctangents of eighths, each as a sum of doubles given by their bits. The
//! tests compare each with a computation in high precision.

/// `π/2 = P₀ + P₁ + P₂ + P₃ + ε`. The parts `P₀ … P₂` are nonnegative, have at most 33 bits, and
/// are multiples of `2⁻³²`, `2⁻⁶⁶` and `2⁻¹⁰¹`. Also `P₁ < 2⁻³³`, `P₂ < 2⁻⁶⁸`, `P₃ < 2⁻¹⁰³`, and
/// `|ε| ≤ 2⁻¹⁵⁶`.
pub(crate) const HALF_PI: [f64; 4] = [
    f64::from_bits(0x3ff9_21fb_5440_0000),
    f64::from_bits(0x3dd0_b461_1a60_0000),
    f64::from_bits(0x3ba3_198a_2e00_0000),
    f64::from_bits(0x397b_839a_2520_49c1),
];

/// `ln 2 = L₀ + L₁ + ε`, where `L₀` is a multiple of `2⁻⁴²`, `0 < L₁ < 2⁻⁴²`, and `|ε| ≤ 2⁻⁹⁶`.
pub(crate) const LN_2: [f64; 2] =
    [f64::from_bits(0x3fe6_2e42_fefa_3800), f64::from_bits(0x3d2e_f357_93c7_6730)];

/// Returns a double, and a second double for the remainder.
const fn pair(head: u64, tail: u64) -> (f64, f64) {
    (f64::from_bits(head), f64::from_bits(tail))
}

/// `arctan(j/8)` for `j = 0, …, 8`. Each value is within `2⁻¹⁰⁶` of the sum of its pair.
pub(crate) const ARCTAN_OF_EIGHTHS: [(f64, f64); 9] = [
    pair(0x0000_0000_0000_0000, 0x0000_0000_0000_0000),
    pair(0x3fbf_d5ba_9aac_2f6e, 0xbc4c_d376_8676_0c17),
    pair(0x3fcf_5b75_f92c_80dd, 0x3c68_ab6e_3cf7_afbd),
    pair(0x3fd6_f619_41e4_def1, 0xbc7c_63aa_e6f6_e918),
    pair(0x3fdd_ac67_0561_bb4f, 0x3c7a_2b7f_222f_65e2),
    pair(0x3fe1_e00b_abde_feb4, 0xbc59_28df_287a_668f),
    pair(0x3fe4_978f_a326_9ee1, 0x3c72_419a_87f2_a458),
    pair(0x3fe7_00a7_c578_4634, 0xbc78_c34d_25aa_def6),
    pair(0x3fe9_21fb_5444_2d18, 0x3c81_a626_3314_5c07),
];

/// `π/2 − arctan(j/8)` for `j = 0, …, 8`. Each value is within `2⁻¹⁰⁶` of the sum of its pair.
pub(crate) const ARCCOT_OF_EIGHTHS: [(f64, f64); 9] = [
    pair(0x3ff9_21fb_5444_2d18, 0x3c91_a626_3314_5c07),
    pair(0x3ff7_249f_aa99_6a21, 0x3c9a_8cc1_e748_0c68),
    pair(0x3ff5_368c_951e_9cfd, 0xbc99_6f47_948a_99f1),
    pair(0x3ff3_6475_03ca_f55c, 0x3c81_7e21_d9a4_2c9a),
    pair(0x3ff1_b6e1_92eb_be44, 0x3c9b_1b46_6a88_828e),
    pair(0x3ff0_31f5_7e54_adbe, 0x3c93_38b4_259c_0270),
    pair(0x3fed_ac67_0561_bb4f, 0x3c8a_2b7f_222f_65e2),
    pair(0x3feb_434e_e310_13fd, 0xbc80_520d_0701_d877),
    pair(0x3fe9_21fb_5444_2d18, 0x3c81_a626_3314_5c07),
];

#[cfg(test)]
mod tests {
    use astro_float::BigFloat;

    use super::*;
    use crate::interval::high_precision::{P, RM, at_most, big, constants, error_of_sum, half_pi};

    /// Fails unless the sum of the parts agrees with the value to within `2ⁿ`.
    #[track_caller]
    fn assert_sum(parts: &[f64], value: &BigFloat, n: i32) {
        let error = error_of_sum(parts, value);
        assert!(at_most(&error, &big(2.0_f64.powi(n))), "{parts:?} miss {value} by {error}");
    }

    fn is_multiple(x: f64, n: i32) -> bool {
        (x * 2.0_f64.powi(-n)).fract() == 0.0
    }

    #[test]
    fn half_pi_is_the_sum_of_its_parts() {
        assert_sum(&HALF_PI, &half_pi(), -156);
        let [p0, p1, p2, p3] = HALF_PI;
        assert!(is_multiple(p0, -32) && is_multiple(p1, -66) && is_multiple(p2, -101));
        assert!(0.0 < p1 && p1 < 2.0_f64.powi(-33));
        assert!(0.0 < p2 && p2 < 2.0_f64.powi(-68));
        assert!(0.0 < p3 && p3 < 2.0_f64.powi(-103));
    }

    #[test]
    fn ln_2_is_the_sum_of_its_parts() {
        assert_sum(&LN_2, &constants().ln_2(P, RM), -96);
        assert!(is_multiple(LN_2[0], -42) && 0.0 < LN_2[1] && LN_2[1] < 2.0_f64.powi(-42));
    }

    #[test]
    fn arctangents_of_eighths_are_the_sums_of_their_parts() {
        let (mut constants, half_pi) = (constants(), half_pi());
        for j in 0..=8 {
            let angle = big(j as f64 / 8.0).atan(P, RM, &mut constants);
            let (head, tail) = ARCTAN_OF_EIGHTHS[j];
            assert_sum(&[head, tail], &angle, -106);
            let (head, tail) = ARCCOT_OF_EIGHTHS[j];
            assert_sum(&[head, tail], &half_pi.sub(&angle, P, RM), -106);
        }
    }
}
