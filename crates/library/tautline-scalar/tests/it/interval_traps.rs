//! Where interval arithmetic often fails: underflow, infinities, NaN and invalid ends.

use std::f64::consts::PI;

use astro_float::{Consts, RoundingMode};
use tautline_scalar::{
    Enclosure, Fast, FastInterval, Interval, IntervalError, Kernel, Rigorous, Scalar,
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
    // The product is a subnormal number that is not exact.
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
    // 0 · ∞ becomes an end only if the other products do not decide it.
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
    // The result is unbounded, not NaN.
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

/// Returns the result of every operation on an undefined interval, which must be undefined.
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
        // These are defined only on a part of the interval.
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
