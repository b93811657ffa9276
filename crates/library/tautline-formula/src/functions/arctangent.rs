//! The arctangent.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Coefficients of `(arctan x − x)/x³` for `|x| ≤ 0.66`, as a quotient (Moshier's Cephes).
const ABOVE: [f64; 5] = [
    -6.485_021_904_942_025_371_773e1,
    -1.228_866_684_490_136_173_410e2,
    -7.500_855_792_314_704_667_340e1,
    -1.615_753_718_733_365_076_637e1,
    -8.750_608_600_031_904_122_785e-1,
];
const BELOW: [f64; 5] = [
    1.945_506_571_482_613_964_425e2,
    4.853_903_996_359_136_964_868e2,
    4.328_810_604_912_902_668_951e2,
    1.650_270_098_316_988_542_046e2,
    2.485_846_490_142_306_297_962e1,
];

/// The number `tan 3π/8`. Beyond it the result is `π/2 − arctan 1/x`.
const STEEP: f64 = 2.414_213_562_373_095_048_80;

/// The difference between `π/2` and the double nearest to it.
const REST: f64 = 6.123_233_995_736_765_886_130e-17;

/// Fills `y` with `arctan x`.
#[inline(always)]
pub(crate) fn atan<const B: usize>(y: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        y[i] = lane(x[i]);
    }
}

#[inline(always)]
fn lane(x: f64) -> f64 {
    let size = x.abs();
    let (is_steep, is_flat) = (size > STEEP, size <= 0.66);
    // arctan t is added to 0, π/4 or π/2. NaN is neither steep nor flat, and stays NaN.
    let [above, below] = if is_steep { [-1.0, size] } else { [size - 1.0, size + 1.0] };
    let quotient = above / below;
    let t = if is_flat { size } else { quotient };
    let [base, rest] = if is_steep { [FRAC_PI_2, REST] } else { [FRAC_PI_4, 0.5 * REST] };
    let [base, rest] = if is_flat { [0.0, 0.0] } else { [base, rest] };
    let z = t * t;
    let [p0, p1, p2, p3, p4] = ABOVE;
    let [q0, q1, q2, q3, q4] = BELOW;
    let p = (((p4 * z + p3) * z + p2) * z + p1) * z + p0;
    let q = ((((z + q4) * z + q3) * z + q2) * z + q1) * z + q0;
    (base + ((t * z * (p / q) + rest) + t)).copysign(x)
}
