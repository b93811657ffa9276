//! The hyperbolic tangent and cosine.

use super::{all, exponential};

/// Coefficients of `(tanh x − x)/x³` for `|x| ≤ 5/8`, as a quotient (Moshier's Cephes).
const ABOVE: [f64; 3] = [
    -1.614_687_684_417_084_479_52e3,
    -9.928_772_310_019_185_865_64e1,
    -9.643_991_794_250_522_386_28e-1,
];
const BELOW: [f64; 3] = [
    4.844_063_053_251_254_860_48e3,
    2.235_488_390_601_004_485_83e3,
    1.128_116_784_916_329_314_02e2,
];

/// Fills `y` with `tanh x`.
#[inline(always)]
pub(crate) fn tanh<const B: usize>(y: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        y[i] = lane(x[i]);
    }
}

#[inline(always)]
fn lane(x: f64) -> f64 {
    let size = x.abs();
    let z = x * x;
    let [p0, p1, p2] = ABOVE;
    let [q0, q1, q2] = BELOW;
    let quotient = ((p2 * z + p1) * z + p0) / (((z + q2) * z + q1) * z + q0);
    let near = x * z * quotient + x;
    // 1 − 2/(e²ˣ + 1), which rounds to 1 from 20 on. NaN takes the branch for small arguments.
    let twice = if size < 22.0 { 2.0 * size } else { 44.0 };
    let far = 1.0 - 2.0 / (exponential::lane(twice) + 1.0);
    // The sign is also copied for small arguments, for the sign of 0.
    if size >= 0.625 { far } else { near }.copysign(x)
}

/// Up to this number the exponential and its reciprocal are normal numbers.
const LARGEST: f64 = 700.0;

/// Fills `y` with `cosh x`.
#[inline(always)]
pub(crate) fn cosh<const B: usize>(y: &mut [f64; B], x: &[f64; B]) {
    for i in 0..B {
        let power = exponential::lane(x[i].abs());
        y[i] = 0.5 * power + 0.5 / power;
    }
    if !all(x, |x| x.abs() <= LARGEST) {
        for i in 0..B {
            // This also catches NaN.
            if !(x[i].abs() <= LARGEST) {
                y[i] = x[i].cosh();
            }
        }
    }
}
