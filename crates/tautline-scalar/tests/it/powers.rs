//! Integer powers with exponents at both ends of their range.

use tautline_scalar::{Interval, Jet2, Pair, Scalar};

use crate::{INFINITY, LEAST, MAX, ends, interval};

/// `|−2³¹|` is not an `i32`. The least exponent is even, unlike `2³¹ − 1`.
#[test]
fn the_least_exponent_is_even() {
    let almost = (-1.0_f64).next_up();
    for n in [i32::MIN, i32::MIN + 2] {
        assert_eq!(ends(Interval::point(-1.0).powi(n)), (1.0, 1.0));
        assert_eq!(ends(Interval::point(-2.0).powi(n)), (0.0, LEAST));
        assert_eq!(ends(Interval::point(-0.5).powi(n)), (MAX, INFINITY));
        assert!(interval(-1.0, 1.0).powi(n).is_undefined());
        let powers = [-1.0, 2.0, -0.5].map(|x: f64| Scalar::powi(x, n));
        assert_eq!(powers, [1.0, 0.0, INFINITY]);
        assert_eq!(Pair::new(-1.0, 2.0).powi(n), Pair::new(1.0, 0.0));
        assert_eq!(Pair::new(-0.5, 1.0).powi(n), Pair::new(INFINITY, 1.0));
    }
    for n in [i32::MIN + 1, i32::MAX] {
        assert_eq!(ends(Interval::point(-1.0).powi(n)), (-1.0, -1.0));
        assert_eq!(Pair::new(-1.0, 1.0).powi(n), Pair::new(-1.0, 1.0));
    }
    // (1 − 2⁻⁵³)ⁿ agrees with exp(−2⁻⁵³ n) to within 2⁻⁷⁵. For n = −2³¹ it is 1 + 2⁻²² + 2⁻⁴⁵.
    let power = Interval::point(almost).powi(i32::MIN);
    let expected = 1.0 + 2.0_f64.powi(-22) + 2.0_f64.powi(-45);
    assert!(power.contains(expected), "{power:?}");
    // The reciprocal has a width of 2⁻⁵². Each of the 31 squares doubles the width and adds two
    // roundings, which gives 2³¹ (2⁻⁵² + 2 · 2⁻⁵²).
    assert!(power.width() < 2.0_f64.powi(-19), "{power:?}");
}

#[test]
fn the_second_power_of_a_jet_is_a_square() {
    let [x] = Jet2::variables(&[interval(-1.0, 2.0)]);
    assert_eq!(ends(x.powi(2).value()), (0.0, 4.0));
}

/// The derivatives of `xⁿ` at 1 are `n` and `n (n − 1)`. For the largest exponents the latter is
/// not an `i32`.
#[test]
fn the_largest_exponents_have_derivatives() {
    for n in [i32::MIN, i32::MIN + 1, i32::MIN + 2, -46_341, 46_342, i32::MAX - 1, i32::MAX] {
        let k = f64::from(n);
        let [x] = Jet2::variables(&[1.0]);
        let power = x.powi(n);
        assert_eq!((power.value(), power.first(0)), (1.0, k), "{n}");
        // The tolerance covers two roundings of a product of 62 bits.
        assert!((power.second(0, 0) / (k * (k - 1.0)) - 1.0).abs() <= 2.0 * f64::EPSILON, "{n}");
        if n <= i32::MIN + 1 {
            // The derivatives are computed as n y/x and n (n − 1) y/x²; away from 1 the divisions
            // matter.
            let place = 1.0 + 0.5 / k;
            let [x] = Jet2::variables(&[place]);
            let power = x.powi(n);
            let first = k * power.value() / place;
            let second = (k - 1.0) * first / place;
            let close = |found: f64, expected: f64| (found / expected - 1.0).abs() <= 1e-15;
            assert!(close(power.first(0), first) && close(power.second(0, 0), second), "{n}");
        }
        let [x] = Jet2::variables(&[Interval::point(1.0)]);
        let power = x.powi(n);
        assert!(power.first(0).contains(k), "{n}: {power:?}");
        assert!(power.second(0, 0).contains(k * (k - 1.0)), "{n}: {power:?}");
    }
}
