//! Where interval arithmetic usually goes wrong: underflow, infinities, NaN, poles and invalid
//! ends.

use std::f64::consts::PI;

use astro_float::{Consts, RoundingMode};
use tautline_scalar::{
    Enclosure, Fast, FastInterval, Interval, IntervalError, Jet2, Kernel, Pair, Rigorous, Scalar,
};

use crate::{
    INFINITY, LEAST, MAX, ends, interval,
    reference::{Function, holds},
};

#[test]
fn invalid_ends_are_errors() {
    assert_eq!(Interval::new(2.0, 1.0), Err(IntervalError::Inverted { lo: 2.0, hi: 1.0 }));
    for (lo, hi) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
        assert!(matches!(Interval::new(lo, hi), Err(IntervalError::NotANumber { .. })));
    }
    for x in [INFINITY, -INFINITY] {
        assert_eq!(Interval::new(x, x), Err(IntervalError::NoRealNumber { lo: x, hi: x }));
    }
    assert!(Interval::new(-INFINITY, INFINITY).is_ok());
}

#[test]
fn a_product_that_underflows_is_not_zero() {
    let tiny = Interval::point(1e-200);
    assert_eq!(ends(tiny * tiny), (0.0, LEAST));
    assert_eq!(ends(-tiny * tiny), (-LEAST, 0.0));
    assert_eq!(ends(interval(-1e-200, 0.0) * 1e-200), (-LEAST, 0.0));
    assert_eq!(ends(interval(-1e-200, 1e-200) * tiny), (-LEAST, LEAST));
    assert_eq!(ends(tiny.sqr()), (0.0, LEAST));
    assert_eq!(ends(tiny.powi(5)), (0.0, LEAST));
    assert_eq!(ends((-tiny).powi(5)), (-LEAST, 0.0));
    assert_eq!(ends(tiny / 1e200), (0.0, LEAST));
    assert_eq!(ends(-tiny / 1e200), (-LEAST, 0.0));
    // A subnormal that is not the exact product.
    let product = Interval::point(3e-162) * 3e-162;
    assert!(product.lo() < product.hi());
}

#[test]
fn an_exact_zero_stays_zero() {
    for x in [interval(1.0, 2.0), interval(-1e300, 1e300), Interval::point(LEAST)] {
        assert_eq!(ends(x * 0.0), (0.0, 0.0));
        assert_eq!(ends(Interval::point(0.0) * x), (0.0, 0.0));
    }
    assert_eq!(ends(Interval::point(0.0) / interval(2.0, 3.0)), (0.0, 0.0));
    assert_eq!(ends(Interval::point(0.0).sqrt()), (0.0, 0.0));
}

#[test]
fn zero_times_infinity_is_not_zero() {
    let unbounded = interval(1.0, INFINITY);
    assert_eq!(Interval::point(0.0) * unbounded, Interval::REALS);
    assert_eq!(unbounded * 0.0, Interval::REALS);
    assert_eq!(Interval::point(-0.0) * -unbounded, Interval::REALS);
    // 0 · ∞ is an end only if the other products do not decide it.
    assert_eq!(ends(interval(0.0, 1.0) * unbounded), (0.0, INFINITY));
    assert_eq!(interval(0.0, 0.0) * Interval::REALS, Interval::REALS);
}

#[test]
fn overflow_gives_one_infinite_end() {
    let x = Interval::point(MAX);
    assert_eq!(ends(x + x), (MAX, INFINITY));
    assert_eq!(ends(x * x), (MAX, INFINITY));
    assert_eq!(ends(-x * x), (-INFINITY, -MAX));
    assert_eq!(ends(x / LEAST), (MAX, INFINITY));
    assert_eq!(ends(x.powi(7)), (MAX, INFINITY));
    assert_eq!(ends(Interval::point(LEAST).powi(-3)), (MAX, INFINITY));
    assert_eq!(ends(x.powi(-7)), (0.0, LEAST));
    assert_eq!(ends(Interval::point(1e5).exp()), (MAX, INFINITY));
    assert_eq!(ends(Interval::point(-1e5).exp()), (0.0, LEAST));
    assert_eq!(ends(Interval::point(-1e5).sinh()), (-INFINITY, -MAX));
    assert_eq!(ends(Interval::point(-1e5).cosh()), (MAX, INFINITY));
    // Unbounded, not NaN.
    assert_eq!(ends(x + x - (x + x)), (-INFINITY, INFINITY));
    assert_eq!(ends((x * x) / (x * x)), (0.0, INFINITY));
}

#[test]
fn functions_of_unbounded_intervals_are_their_limits() {
    let line = Interval::REALS;
    assert_eq!(ends(line.exp()), (0.0, INFINITY));
    assert_eq!(ends(line.tanh()), (-1.0, 1.0));
    assert_eq!(ends(line.sin()), (-1.0, 1.0));
    assert_eq!(ends(line.sqr()), (0.0, INFINITY));
    assert_eq!(ends(line.cosh()), (1.0, INFINITY));
    assert_eq!(line.sinh(), line);
    let angle = line.atan();
    assert!(angle.lo() < -PI / 2.0 && angle.hi() > PI / 2.0 && angle.magnitude() < 1.571);
    assert_eq!(ends(interval(1.0, INFINITY).ln()), (0.0, INFINITY));
    assert_eq!(ends(interval(4.0, INFINITY).sqrt()), (2.0, INFINITY));
    let fast: FastInterval = line.with_kernel();
    assert_eq!((fast.exp().lo(), fast.exp().hi()), (0.0, INFINITY));
    assert_eq!((fast.cosh().lo(), fast.sinh().hi()), (1.0, INFINITY));
}

/// The result of every operation on undefined, which must be undefined.
fn of_the_undefined<K: Kernel>() -> Vec<Enclosure<K>> {
    let x = Enclosure::<K>::UNDEFINED;
    let one = Enclosure::<K>::point(1.0);
    let zero = Enclosure::<K>::point(0.0);
    let mut results = vec![
        -x,
        x + one,
        one + x,
        x - one,
        one - x,
        x * one,
        one * x,
        x * zero,
        zero * x,
        x / one,
        one / x,
        x + 1.0,
        x * 0.0,
        x / 2.0,
        x.hull(one),
        one.hull(x),
        x.sqr(),
        x.recip(),
        x.sqrt(),
        x.sin_cos().0,
        x.sin_cos().1,
        x.sinh_cosh().0,
        x.sinh_cosh().1,
    ];
    results.extend(Function::ALL.map(|f| f.of(x)));
    results.extend([-3, -2, -1, 0, 1, 2, 3].map(|n| x.powi(n)));
    results.extend(x.intersection(one));
    results
}

#[test]
fn the_undefined_stays_undefined() {
    for x in of_the_undefined::<Rigorous>() {
        assert!(x.is_undefined() && x.lo().is_nan() && x.hi().is_nan(), "{x:?}");
    }
    assert!(of_the_undefined::<Fast>().iter().all(|x| x.is_undefined()));
    let x = Interval::UNDEFINED;
    assert!(!x.contains(0.0) && !x.is_finite() && !x.contains_interval(x));
    for number in [x.width(), x.midpoint(), x.radius(), x.magnitude(), x.mignitude()] {
        assert!(number.is_nan());
    }
}

#[test]
fn nan_is_never_a_finite_enclosure() {
    let x = interval(-1.0, 1.0);
    let undefined = [
        Interval::constant(f64::NAN),
        Interval::constant(INFINITY),
        x + f64::NAN,
        x * INFINITY,
        x * f64::NAN,
        x / 0.0,
        x / x,
        x.recip().atan(),
        x.sqrt().tanh(),
        x.ln().cos() * 0.0,
        x.powi(-2),
        // Defined on part of the interval only.
        (x + 1.0).ln(),
        (x + 0.5).sqrt(),
        (x * 2.0).tan(),
    ];
    for (i, y) in undefined.into_iter().enumerate() {
        assert!(y.is_undefined(), "formula {i}: {y:?}");
    }
    assert!((x + 1.0).sqrt().is_finite());
}

#[test]
fn an_interval_that_contains_zero_has_no_finite_reciprocal() {
    for x in [interval(-1.0, 1.0), interval(0.0, 1.0), interval(-1.0, -0.0), interval(0.0, 0.0)] {
        assert!(x.recip().is_undefined() && (Interval::point(1.0) / x).is_undefined());
        assert!(x.powi(-1).is_undefined() && x.powi(-4).is_undefined());
    }
    assert_eq!(ends(interval(LEAST, 1.0).recip()), (1.0, INFINITY));
    assert_eq!(ends(interval(-1.0, -LEAST).recip()), (-INFINITY, -1.0));
}

#[test]
fn roots_and_logarithms_of_negative_numbers_are_undefined() {
    for x in [interval(-1.0, -0.5), interval(-LEAST, 1.0)] {
        assert!(x.sqrt().is_undefined() && x.ln().is_undefined());
    }
    assert!(interval(0.0, 1.0).ln().is_undefined());
    assert_eq!(ends(interval(-0.0, 4.0).sqrt()), (0.0, 2.0));
}

#[test]
fn ln_2_is_enclosed() {
    let mut constants = Consts::new().expect("memory");
    let ln_2 = constants.ln_2(256, RoundingMode::None);
    assert!(holds(Interval::point(2.0).ln(), &ln_2));
    assert!(holds(FastInterval::point(2.0).ln(), &ln_2));
    assert!(Interval::point(2.0).ln().width() <= 3.0 * f64::EPSILON);
}

#[test]
fn a_tangent_across_a_pole_is_undefined() {
    assert!(interval(1.5, 1.6).tan().is_undefined());
    assert!(interval(-20.0, 20.0).tan().is_undefined());
    assert!(interval(4.7, 4.72).tan().is_undefined());
    // The doubles nearest to π/2 lie on either side of the pole.
    let (below, above) = (PI / 2.0, (PI / 2.0).next_up());
    assert!(interval(below, above).tan().is_undefined());
    assert!(Interval::point(below).tan().lo() > 1e16);
    assert!(Interval::point(above).tan().hi() < -1e15);
    assert!(interval(-1.5, 1.5).tan().is_finite());
    // Beyond the largest angle nothing is known.
    assert!(Interval::point(1e10).tan().is_undefined());
}

#[test]
fn waves_reach_one_exactly_where_a_crest_is_inside() {
    for turn in [0.0, 1.0, -3.0, 1000.0] {
        let shift = turn * 2.0 * PI;
        let x = |lo: f64, hi: f64| interval(lo + shift, hi + shift);
        assert_eq!(x(-0.1, 0.1).cos().hi(), 1.0);
        assert_eq!(x(3.1, 3.2).cos().lo(), -1.0);
        assert_eq!(x(1.5, 1.6).sin().hi(), 1.0);
        assert_eq!(x(4.7, 4.8).sin().lo(), -1.0);
        assert!(x(0.1, 3.0).cos().hi() < 0.996 && x(0.1, 3.0).cos().lo() > -0.9901);
        assert!(x(1.6, 4.7).sin().hi() < 1.0 && x(1.6, 4.7).sin().lo() > -1.0);
        assert_eq!(ends(x(0.0, 7.0).sin()), (-1.0, 1.0));
    }
    // Beyond the largest angle.
    assert_eq!(ends(Interval::point(1e22).sin()), (-1.0, 1.0));
    assert_eq!(ends(interval(0.0, 1e7).cos()), (-1.0, 1.0));
}

#[test]
fn midpoints_are_finite_and_inside() {
    let odd = LEAST * 3.0;
    for x in [
        interval(MAX, MAX),
        interval(-MAX, MAX),
        interval(odd, odd),
        interval(LEAST, odd),
        interval(-LEAST, LEAST),
        interval(1.0, INFINITY),
        interval(-INFINITY, -1.0),
        Interval::REALS,
    ] {
        let m = x.midpoint();
        assert!(m.is_finite() && x.contains(m), "{x:?}: {m}");
        assert!(x.radius() >= 0.0);
    }
    assert_eq!(interval(1.0, 4.0).midpoint(), 2.5);
    assert_eq!(interval(1.0, 4.0).radius(), 1.5);
}

#[test]
fn intersections_hulls_and_sizes() {
    let (x, y) = (interval(-3.0, 1.0), interval(0.0, 2.0));
    assert_eq!(x.intersection(y).map(ends), Some((0.0, 1.0)));
    assert_eq!(x.intersection(interval(1.5, 2.0)), None);
    assert_eq!(ends(x.hull(interval(5.0, 6.0))), (-3.0, 6.0));
    assert_eq!((x.magnitude(), x.mignitude(), (-y - 1.0).mignitude()), (3.0, 0.0, 1.0));
    assert!(x.contains_interval(interval(-1.0, 0.5)) && !x.contains_interval(y));
    assert!(!Interval::REALS.contains(INFINITY));
}

/// `|−2³¹|` is not an `i32`; the exponent is even, unlike `2³¹ − 1`.
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
    // (1 − 2⁻⁵³)ⁿ = exp(−2⁻⁵³ n) to 2⁻⁷⁵, for n = −2³¹: 1 + 2⁻²² + 2⁻⁴⁵.
    let power = Interval::point(almost).powi(i32::MIN);
    let expected = 1.0 + 2.0_f64.powi(-22) + 2.0_f64.powi(-45);
    assert!(power.contains(expected), "{power:?}");
    // The reciprocal has a width of 2⁻⁵², and each of the 31 squares doubles that and adds two
    // roundings: 2³¹ (2⁻⁵² + 2 · 2⁻⁵²).
    assert!(power.width() < 2.0_f64.powi(-19), "{power:?}");
}

#[test]
fn the_second_power_of_a_jet_is_a_square() {
    let [x] = Jet2::variables(&[interval(-1.0, 2.0)]);
    assert_eq!(ends(x.powi(2).value()), (0.0, 4.0));
}

/// The derivatives of `xⁿ` at 1 are `n` and `n (n − 1)`, which is no `i32` for the largest
/// exponents.
#[test]
fn the_largest_exponents_have_derivatives() {
    for n in [i32::MIN, i32::MIN + 1, i32::MIN + 2, -46_341, 46_342, i32::MAX - 1, i32::MAX] {
        let k = f64::from(n);
        let [x] = Jet2::variables(&[1.0]);
        let power = x.powi(n);
        assert_eq!((power.value(), power.first(0)), (1.0, k), "{n}");
        // Two roundings of a product of 62 bits.
        assert!((power.second(0, 0) / (k * (k - 1.0)) - 1.0).abs() <= 2.0 * f64::EPSILON, "{n}");
        if n <= i32::MIN + 1 {
            // These use n y/x and n (n − 1) y/x², and beside 1 the divisions matter.
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
