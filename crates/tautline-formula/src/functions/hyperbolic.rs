//! The hyperbolic tangent and cosine.

use super::{all, exponential};

/// `(tanh x − x)/x³` for `|x| ≤ 5/8`, a quotient (Moshier's Cephes).
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
    // 1 − 2/(e²ˣ + 1), which is 1 to rounding from 20 on. NaN is in neither half of the range, and near.
    let twice = if size < 22.0 { 2.0 * size } else { 44.0 };
    let far = 1.0 - 2.0 / (exponential::lane(twice) + 1.0);
    // Near too: 0 has a sign.
    if size >= 0.625 { far } else { near }.copysign(x)
}

/// Up to here neither the exponential nor its reciprocal leaves the normal numbers.
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
            // NaN too.
            if !(x[i].abs() <= LARGEST) {
                y[i] = x[i].cosh();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use astro_float::{BigFloat, Consts, RoundingMode};

    use super::{
        super::tests::{assert_within, even, geometric, single},
        cosh, tanh,
    };

    fn of(x: f64) -> f64 {
        single(x, tanh, tanh)
    }

    fn value(x: &BigFloat, constants: &mut Consts) -> BigFloat {
        x.tanh(192, RoundingMode::None, constants)
    }

    #[test]
    fn errors_of_the_hyperbolic_tangent_are_as_stated() {
        assert_within(2.0, 0.0, even(-0.7, 0.7), of, value);
        assert_within(2.0, 0.0, even(-4.0, 4.0), of, value);
        assert_within(1.0, 0.0, geometric(1e-20, 0.6), of, value);
    }

    #[test]
    fn far_away_it_is_one() {
        for x in [20.0, 22.0, 30.0, 1e300, f64::INFINITY] {
            assert_eq!((of(x), of(-x)), (1.0, -1.0), "{x}");
        }
        assert!(of(f64::NAN).is_nan());
        assert_eq!([of(0.0), of(-0.0)].map(f64::to_bits), [0.0, -0.0].map(f64::to_bits));
    }

    #[test]
    fn errors_of_the_hyperbolic_cosine_are_as_stated() {
        let of = |x: f64| single(x, cosh, cosh);
        let value =
            |x: &BigFloat, constants: &mut Consts| x.cosh(192, RoundingMode::None, constants);
        assert_within(2.0, 0.0, even(-4.0, 4.0), of, value);
        assert_within(2.0, 0.0, even(-700.0, 700.0), of, value);
        for x in [700.5, -800.0, f64::INFINITY, f64::NAN] {
            assert_eq!(of(x).to_bits(), x.cosh().to_bits(), "{x}");
        }
        assert_eq!((of(0.0), of(-0.0)), (1.0, 1.0));
    }
}
