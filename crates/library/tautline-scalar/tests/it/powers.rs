//! Integer powers with exponents at both ends of their range.

use tautline_chance::{Random, cases, seed};
use tautline_scalar::{Interval, Jet1, Jet2, Pair, Scalar};

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

/// Exponents at the ends of the range, at both ends of those whose factor `n (n − 1)` is a double,
/// and random ones.
fn exponents() -> Vec<i32> {
    let edges = [0, 1 << 26, -(1 << 26), 94_906_265, -94_906_265, 2_147_483_645];
    let near = |n: i32| (-3..=3).map(move |more| n.saturating_add(more));
    let mut all: Vec<i32> = edges.into_iter().flat_map(near).collect();
    all.extend((0..4).map(|more| i32::MIN + more));
    let mut random = Random(seed(14));
    all.extend((0..cases(4000)).map(|_| (random.bits() as i32) >> (random.bits() % 32)));
    all
}

/// The second derivative of `xⁿ` at 1 is `n (n − 1)`, which has up to 62 bits. Integers tell whether
/// it lies in the enclosure; the rounded product of doubles is no help.
#[test]
fn the_second_derivative_of_a_power_is_enclosed_for_every_exponent() {
    let mut inexact = 0;
    for n in exponents() {
        let exact = i128::from(n) * (i128::from(n) - 1);
        // At −1 its sign is that of the parity of n.
        for (x, sign) in [(1.0, 1), (-1.0, if n % 2 == 0 { 1 } else { -1 })] {
            let [at] = Jet2::variables(&[Interval::point(x)]);
            let [twice] = Jet1::variables(&Jet1::variables(&[Interval::point(x)]));
            let [third] = Jet2::variables(&Jet1::variables(&[Interval::point(x)]));
            for second in [
                at.powi(n).second(0, 0),
                twice.powi(n).first(0).first(0),
                third.powi(n).second(0, 0).value(),
                third.powi(n).first(0).first(0),
            ] {
                // The ends are integers, since they are doubles that are large or exact.
                let (lo, hi) = (second.lo() as i128, second.hi() as i128);
                assert!(lo <= sign * exact && sign * exact <= hi, "{n} at {x}: {second:?} {exact}");
                assert!(
                    hi - lo <= 2 * (exact >> 52) + i128::from(exact > 1 << 53),
                    "{n}: {second:?}"
                );
                inexact += usize::from(lo < hi);
            }
            let cube = sign * exact * (i128::from(n) - 2) * i128::from(x as i32);
            let found = third.powi(n).second(0, 0).first(0);
            let near = |end: f64| (end / cube as f64 - 1.0).abs() < 1e-14;
            let holds = found.lo() as i128 <= cube && cube <= found.hi() as i128;
            // Beyond 2¹²⁷ nothing is compared.
            assert!(holds && (cube == 0 || near(found.lo()) && near(found.hi())), "{n}: {found:?}");
        }
    }
    assert!(inexact > 1000, "{inexact}");
}

/// In `f64` and in pairs the factor is rounded once, before the product.
#[test]
fn the_second_derivative_of_a_power_in_f64_rounds_its_factor_first() {
    let mut random = Random(seed(15));
    for n in exponents().into_iter().filter(|&n| !(0..=2).contains(&n) && n > i32::MIN + 1) {
        let (k, x) = (f64::from(n), 1.0 + random.between(-1.0, 1.0) / f64::from(n).abs());
        let expected = Scalar::powi(x, n - 2) * (k * (k - 1.0));
        let [one] = Jet2::variables(&[x]);
        assert_eq!(one.powi(n).second(0, 0).to_bits(), expected.to_bits(), "{n} at {x}");
        let [two] = Jet2::variables(&[Pair::new(x, 1.0)]);
        let pair = two.powi(n).second(0, 0).both();
        assert_eq!(pair.map(f64::to_bits), [expected, k * (k - 1.0)].map(f64::to_bits), "{n}");
    }
}
