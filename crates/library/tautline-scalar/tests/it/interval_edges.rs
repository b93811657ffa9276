//! Intervals as sets: their ends, sizes, intersections and hulls, and exact values.

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
        // The value is exact up to one rounding in each step.
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
    assert!(x.contains_interval(interval(-1.0, 0.5)) && !Interval::REALS.contains(INFINITY));
    for outside in [interval(-1.5, 0.0), interval(0.0, 2.5), interval(-1.5, 2.5)] {
        assert!(!x.contains_interval(outside), "{outside:?}");
    }
    for half in [interval(1.0, INFINITY), interval(-INFINITY, 1.0), Interval::REALS] {
        assert!(!half.is_finite() && !half.is_undefined());
    }
}

#[test]
fn intersections_hulls_and_sizes() {
    for (x, y, both, hull) in [
        (interval(-3.0, 1.0), interval(0.0, 2.0), Some((0.0, 1.0)), (-3.0, 2.0)),
        (interval(-3.0, 1.0), interval(1.5, 2.0), None, (-3.0, 2.0)),
        (interval(-3.0, 1.0), interval(5.0, 6.0), None, (-3.0, 6.0)),
        (interval(-1.0, 2.0), interval(-3.0, 1.0), Some((-1.0, 1.0)), (-3.0, 2.0)),
        (interval(-1.0, 2.0), interval(-3.0, 3.0), Some((-1.0, 2.0)), (-3.0, 3.0)),
        (interval(-1.0, 2.0), interval(0.0, 3.0), Some((0.0, 2.0)), (-1.0, 3.0)),
        // One common point is enough.
        (interval(-1.0, 2.0), interval(2.0, 3.0), Some((2.0, 2.0)), (-1.0, 3.0)),
    ] {
        for (x, y) in [(x, y), (y, x)] {
            assert_eq!(x.intersection(y).map(ends), both, "{x:?} and {y:?}");
            assert_eq!(ends(x.hull(y)), hull, "{x:?} and {y:?}");
        }
        let none = Interval::UNDEFINED;
        assert!(x.intersection(none).is_some_and(Interval::is_undefined));
        assert!(none.intersection(x).is_some_and(Interval::is_undefined));
    }
    for (lo, hi, magnitude, mignitude) in [
        (-3.0, 1.0, 3.0, 0.0),
        (-1.0, 2.0, 2.0, 0.0),
        (-2.0, 1.0, 2.0, 0.0),
        (0.0, 3.0, 3.0, 0.0),
        (-3.0, 0.0, 3.0, 0.0),
        (2.0, 3.0, 3.0, 2.0),
        (-3.0, -2.0, 3.0, 2.0),
        (-3.0, -1.0, 3.0, 1.0),
    ] {
        let x = interval(lo, hi);
        assert_eq!((x.magnitude(), x.mignitude()), (magnitude, mignitude), "{x:?}");
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

/// Arguments on either side of 711 and −746, beyond which nothing is computed.
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
