//! Edge cases of intervals: ends, rounding of sizes, exact values and the largest angles.

use astro_float::{BigFloat, RoundingMode};
use tautline_scalar::{Enclosure, Fast, Interval, Kernel, Rigorous, Scalar};

use crate::{INFINITY, LEAST, MAX, ends, interval, reference::Reference};

#[test]
fn sizes_of_intervals_are_rounded_up() {
    let (one, next) = (1.0, 1.0_f64.next_up());
    for x in [
        interval(one, next),
        interval(-next, -one),
        interval(0.0, LEAST),
        interval(-LEAST, 0.0),
        interval(LEAST, LEAST * 2.0),
        interval(-1e-30, 1.0),
        interval(-1.0, 1e-30),
        interval(0.1, 0.3),
        interval(-0.3, 0.7),
        interval(1.0, 1e300),
        interval(-MAX, MAX),
    ] {
        let (centre, radius) = (x.midpoint(), x.radius());
        // The comparison is exact.
        let big = |x: f64| Reference::big(x);
        let apart = |a: f64, b: f64| big(a).sub(&big(b), 4096, RoundingMode::None);
        let within = |distance: BigFloat, bound: f64| {
            bound == INFINITY || distance.cmp(&big(bound)).is_some_and(|order| order <= 0)
        };
        assert!(within(apart(x.hi(), centre), radius), "{x:?} {radius:e}");
        assert!(within(apart(centre, x.lo()), radius), "{x:?} {radius:e}");
        assert!(within(apart(x.hi(), x.lo()), x.width()), "{x:?} {:e}", x.width());
        // Up to one rounding of each step.
        let most = x.hi() * 0.5 - x.lo() * 0.5;
        assert!(radius <= most * (1.0 + 1e-15) + f64::EPSILON * x.magnitude() + LEAST, "{x:?}");
    }
}

#[test]
fn the_ends_of_an_interval_belong_to_it() {
    let x = interval(-1.0, 2.0);
    assert!(x.contains(-1.0) && x.contains(2.0));
    assert!(!x.contains((-1.0_f64).next_down()) && !x.contains(2.0_f64.next_up()));
    assert!(x.contains_interval(x));
    for outside in [interval(-1.5, 0.0), interval(0.0, 2.5), interval(-1.5, 2.5)] {
        assert!(!x.contains_interval(outside), "{outside:?}");
    }
    // One common point is enough.
    assert_eq!(x.intersection(interval(2.0, 3.0)).map(ends), Some((2.0, 2.0)));
    assert_eq!(interval(2.0, 3.0).intersection(x).map(ends), Some((2.0, 2.0)));
    assert_eq!(ends(x.hull(interval(-3.0, 1.0))), (-3.0, 2.0));
    assert_eq!(ends(x.hull(interval(0.0, 3.0))), (-1.0, 3.0));
    assert_eq!(ends(interval(-3.0, 3.0).hull(x)), (-3.0, 3.0));
    assert_eq!((x.magnitude(), interval(-2.0, 1.0).magnitude()), (2.0, 2.0));
    assert_eq!((interval(0.0, 3.0).mignitude(), interval(-3.0, 0.0).mignitude()), (0.0, 0.0));
    assert_eq!((interval(2.0, 3.0).mignitude(), interval(-3.0, -2.0).mignitude()), (2.0, 2.0));
    for half in [interval(1.0, INFINITY), interval(-INFINITY, 1.0), Interval::REALS] {
        assert!(!half.is_finite() && !half.is_undefined());
    }
    // Undefined in either place gives undefined.
    let none = Interval::UNDEFINED;
    assert!(x.intersection(none).is_some_and(Interval::is_undefined));
    assert!(none.intersection(x).is_some_and(Interval::is_undefined));
}

/// Up to `2²⁰`, inclusive, of either sign; one larger end is enough to know nothing.
#[test]
fn angles_of_either_sign_have_the_same_limit() {
    const LARGEST: f64 = 1_048_576.0;
    let (last, beyond) = (LARGEST, LARGEST.next_up());
    for sign in [1.0, -1.0] {
        let x = Interval::point(sign * last);
        for y in [x.sin(), x.cos(), x.sin_cos().0, x.sin_cos().1, x.tan()] {
            assert!(y.width() < 1e-14, "{y:?}");
        }
        let half = |far: f64| if sign > 0.0 { interval(0.0, far) } else { interval(-far, 0.0) };
        for x in [Interval::point(sign * beyond), half(beyond), half(1e10), half(1e300)] {
            for y in [x.sin(), x.cos(), x.sin_cos().0, x.sin_cos().1] {
                assert_eq!(ends(y), (-1.0, 1.0), "{x:?}");
            }
            assert!(x.tan().is_undefined());
        }
    }
}

fn exact_values<K: Kernel>() {
    let point = Enclosure::<K>::point;
    for zero in [0.0, -0.0].map(point) {
        for y in [zero.sin(), zero.tan(), zero.atan(), zero.sinh(), zero.tanh(), zero.sin_cos().0] {
            assert_eq!((y.lo(), y.hi()), (0.0, 0.0));
        }
        for y in [zero.exp(), zero.cos(), zero.cosh(), zero.sin_cos().1, zero.powi(0)] {
            assert_eq!((y.lo(), y.hi()), (1.0, 1.0));
        }
    }
    assert_eq!(point(1.0).ln(), point(0.0));
}

#[test]
fn exact_values_stay_exact() {
    exact_values::<Rigorous>();
    exact_values::<Fast>();
}

/// On either side of 711 and −746, beyond which nothing is computed.
#[test]
fn an_exponential_beyond_the_doubles_is_bounded_by_the_largest() {
    for x in [709.8, 710.0, 711.0, 711.0_f64.next_up(), 1e300] {
        assert_eq!(ends(Interval::point(x).exp()), (MAX, INFINITY), "{x}");
    }
    for x in [-745.2, -746.0, (-746.0_f64).next_down(), -1e300] {
        assert_eq!(ends(Interval::point(x).exp()), (0.0, LEAST), "{x}");
    }
}

fn hyperbolic_tangents<K: Kernel>() {
    for x in [17.0, 19.0, 19.1, 20.0, 25.0, 300.0, 1e4] {
        let y = Enclosure::<K>::point(x).tanh();
        assert!(y.lo() < 1.0 && y.hi() <= 1.0, "{x}: {y:?}");
        let y = Enclosure::<K>::point(-x).tanh();
        assert!(y.lo() >= -1.0 && y.hi() > -1.0, "{x}: {y:?}");
    }
}

#[test]
fn hyperbolic_tangents_never_reach_one() {
    hyperbolic_tangents::<Rigorous>();
    hyperbolic_tangents::<Fast>();
}

/// Next to multiples of `π/2`, where a value is ±1 to rounding.
#[test]
fn enclosures_of_waves_stay_within_one() {
    for quarter in -3000..3000 {
        let mut angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
        for _ in 0..3 {
            let x = Interval::point(angle);
            let (sin, cos) = x.sin_cos();
            for y in [sin, cos, x.sin(), x.cos(), x.tanh()] {
                assert!(-1.0 <= y.lo() && y.hi() <= 1.0, "{angle}: {y:?}");
            }
            angle = angle.next_up();
        }
    }
}
