//! Sine and cosine.

use std::f64::consts::FRAC_2_PI;

use super::{ROUND, all};

/// For larger angles, three parts of `π/2` are not precise enough.
const LARGEST: f64 = 1e6;

/// `π/2` in three parts. The first two parts end in so many zero bits that their products with the
/// number of quarter turns are exact (Cody and Waite; the parts are from Cephes).
const HALF_PI: [f64; 3] = [
    2.0 * 7.853_981_554_508_209_228_515_625e-1,
    2.0 * 7.946_627_356_147_928_367_14e-9,
    2.0 * 3.061_616_997_868_382_943_07e-17,
];

/// Coefficients of `(sin x − x)/x³` and `(cos x − 1 + x²/2)/x⁴` for `|x| ≤ π/4` (Moshier's Cephes).
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_070_47e-1,
    8.333_333_333_322_118_588_78e-3,
    -1.984_126_982_958_953_859_96e-4,
    2.755_731_362_138_572_452_13e-6,
    -2.505_074_776_285_780_728_66e-8,
    1.589_623_015_765_465_680_60e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_659_292_18e-2,
    -1.388_888_888_887_305_641_16e-3,
    2.480_158_728_885_170_453_48e-5,
    -2.755_731_417_929_673_881_12e-7,
    2.087_570_084_197_473_167_78e-9,
    -1.135_853_652_138_768_173_00e-11,
];

/// Fills `sin` and `cos` with the sines and cosines of `x`, in radians.
#[inline(always)]
pub(crate) fn sin_cos<const B: usize>(sin: &mut [f64; B], cos: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        (sin[i], cos[i]) = lane(x[i]);
    }
    if !all(x, |x| x.abs() <= LARGEST) {
        for i in 0..B {
            // This also catches NaN.
            if !(x[i].abs() <= LARGEST) {
                (sin[i], cos[i]) = x[i].sin_cos();
            }
        }
    }
}

#[inline(always)]
fn lane(x: f64) -> (f64, f64) {
    const SIGN: u64 = 1 << 63;
    let size = x.abs();
    let shifted = size * FRAC_2_PI + ROUND;
    let turns = shifted - ROUND;
    // Its last bits are the number of quarter turns.
    let quarter = shifted.to_bits();
    let [first, second, third] = HALF_PI;
    let r = ((size - turns * first) - turns * second) - turns * third;
    let z = r * r;
    let z2 = z * z;
    let [s0, s1, s2, s3, s4, s5] = SINE;
    let [c0, c1, c2, c3, c4, c5] = COSINE;
    let sine = ((s5 * z + s4) * z2 + (s3 * z + s2)) * z2 + (s1 * z + s0);
    let cosine = ((c5 * z + c4) * z2 + (c3 * z + c2)) * z2 + (c1 * z + c0);
    let sine = (r * z * sine + r).to_bits();
    let cosine = (z2 * cosine + (1.0 - z * 0.5)).to_bits();
    // An odd number of quarter turns swaps sine and cosine.
    let exchanged = (sine ^ cosine) & (quarter & 1).wrapping_neg();
    let sign_of_sine = ((quarter & 2) << 62) ^ (x.to_bits() & SIGN);
    let sign_of_cosine = (quarter.wrapping_add(1) & 2) << 62;
    (
        f64::from_bits((sine ^ exchanged) ^ sign_of_sine),
        f64::from_bits((cosine ^ exchanged) ^ sign_of_cosine),
    )
}
