//! Laws of interval arithmetic: operations are as tight as possible, they are monotone under
//! inclusion, and exact results stay exact.

use astro_float::{BigFloat, RoundingMode};
use tautline_chance::{cases, seed};
use tautline_scalar::{Enclosure, Fast, Interval, Kernel, Rigorous, Scalar};

use crate::{
    interval,
    reference::{Function, Random, Reference, holds},
};

const CASES: u32 = 100_000;
const P: usize = 320;
/// The precision that represents any sum of two doubles exactly.
const SUM: usize = 2304;
const RM: RoundingMode = RoundingMode::None;

/// Returns a random number. Many of these numbers coincide, are zero or have few digits.
fn number(random: &mut Random) -> f64 {
    match random.bits() % 6 {
        0 => (random.bits() % 9) as f64 - 4.0,
        1 => random.sign() * random.with_exponent(-1074, 1023),
        2 => random.sign() * random.with_exponent(-3, 3),
        3 => random.sign() * (1.0 + f64::EPSILON * (random.bits() % 5) as f64),
        4 => random.sign() * random.with_exponent(-540, -500),
        _ => random.between(-2.0, 2.0),
    }
}

fn some_interval(random: &mut Random) -> Interval {
    let (a, b) = (number(random), number(random));
    let b = match random.bits() % 4 {
        0 => a,
        1 => a + (b - a) * 1e-15,
        _ => b,
    };
    if a <= b { interval(a, b) } else { interval(b, a) }
}

/// Returns a subinterval, which often shares an end with `x` or has a neighbour of one.
fn part(x: Interval, random: &mut Random) -> Interval {
    let mut end = |fallback: f64| match random.bits() % 4 {
        0 => fallback,
        1 => fallback.next_up().clamp(x.lo(), x.hi()),
        2 => fallback.next_down().clamp(x.lo(), x.hi()),
        _ => random.between(x.lo(), x.hi()).clamp(x.lo(), x.hi()),
    };
    let (a, b) = (end(x.lo()), end(x.hi()));
    if a <= b { interval(a, b) } else { interval(b, a) }
}

type Binary<K> = fn(Enclosure<K>, Enclosure<K>) -> Enclosure<K>;

fn operations<K: Kernel>() -> [Binary<K>; 4] {
    [|x, y| x + y, |x, y| x - y, |x, y| x * y, |x, y| x / y]
}

#[test]
fn arithmetic_encloses_and_is_tightest() {
    let mut random = Random(seed(1));
    for _ in 0..cases(CASES) {
        let (a, b) = (number(&mut random), number(&mut random));
        let (x, y) = (Reference::big(a), Reference::big(b));
        // Sums and products are exact. A quotient that is not a double has a relative distance from
        // all doubles of more than 2⁻¹⁰⁷.
        let exact: [BigFloat; 4] =
            [x.add(&y, SUM, RM), x.sub(&y, SUM, RM), x.mul(&y, P, RM), x.div(&y, P, RM)];
        for (i, (operation, value)) in operations::<Rigorous>().iter().zip(&exact).enumerate() {
            if i == 3 && b == 0.0 {
                continue;
            }
            let z = operation(Interval::point(a), Interval::point(b));
            assert!(holds(z, value), "{i}: {a:e}, {b:e}: {z:?} misses {value}");
            // The result is as tight as possible, except for products and quotients near the ends
            // of the range.
            let inside = |size: f64| (1e-285..1e297).contains(&size);
            let inside = inside(z.mignitude()) && (i < 2 || inside(a.abs()));
            if z.lo() != z.hi() && inside && (i < 2 || b.abs() < 1e297) {
                assert_eq!(z.lo().next_up(), z.hi(), "{i}: {a:e}, {b:e}");
                assert!(!holds(Interval::point(z.lo()), value), "{i}: {a:e}, {b:e}");
            }
        }
    }
}

#[test]
fn roots_enclose_and_are_tightest() {
    let mut random = Random(seed(2));
    for _ in 0..cases(CASES) {
        let a = number(&mut random).abs();
        let z = Interval::point(a).sqrt();
        assert!(holds(z, &Reference::big(a).sqrt(P, RM)), "{a:e}: {z:?}");
        if a > 1e-285 && a < 1e306 {
            assert!(z.lo() == z.hi() || z.lo().next_up() == z.hi(), "{a:e}: {z:?}");
        }
        let square = Interval::point(a.sqrt()).sqr();
        assert!(square.sqrt().contains(a.sqrt()));
    }
    assert_eq!(Interval::point(9.0).sqrt(), Interval::point(3.0));
}

#[test]
fn arithmetic_is_monotone_under_inclusion() {
    let mut random = Random(seed(3));
    // The range in which arithmetic is as tight as possible. Outside it a result may be one double
    // wider.
    let middle = |x: Interval| {
        let sizes = [x.lo().abs(), x.hi().abs()];
        sizes.iter().all(|&s| s == 0.0 || (1e-140..1e140).contains(&s))
    };
    let mut tried = 0;
    for _ in 0..3 * CASES {
        let (x, y) = (some_interval(&mut random), some_interval(&mut random));
        let (u, v) = (part(x, &mut random), part(y, &mut random));
        if ![x, y, u, v].into_iter().all(middle) {
            continue;
        }
        tried += 1;
        for (i, operation) in operations::<Rigorous>().iter().enumerate() {
            let (whole, inner) = (operation(x, y), operation(u, v));
            if !whole.is_undefined() {
                assert!(whole.contains_interval(inner), "{i}: {x:?} {y:?} ⊃ {u:?} {v:?}");
            }
        }
        let powers: [fn(Interval) -> Interval; 4] =
            [Scalar::sqr, |x| x.powi(3), |x| x.powi(4), Scalar::sqrt];
        for (i, f) in powers.iter().enumerate() {
            let (whole, inner) = (f(x), f(u));
            if !whole.is_undefined() && middle(whole) {
                assert!(whole.contains_interval(inner), "{i}: {x:?} ⊃ {u:?}");
            }
        }
    }
    assert!(tried > CASES);
}

/// The elementary functions are monotone only up to the width of an enclosure, at most eight ulps.
fn functions_are_monotone<K: Kernel>() {
    let mut random = Random(seed(4));
    let wider = |x: Enclosure<K>| {
        let more = 8.0 * f64::EPSILON * x.magnitude().max(1e-300);
        let bound = Enclosure::<K>::new(x.lo() - more, x.hi() + more);
        bound.unwrap_or(Enclosure::REALS)
    };
    for _ in 0..cases(CASES) {
        let x = some_interval(&mut random);
        let (x, u) = (x.with_kernel::<K>(), part(x, &mut random).with_kernel::<K>());
        for f in Function::ALL {
            let (whole, inner) = (f.of(x), f.of(u));
            if !whole.is_undefined() {
                assert!(wider(whole).contains_interval(inner), "{f:?}: {x:?} ⊃ {u:?}");
            }
        }
    }
}

#[test]
fn elementary_functions_are_monotone_under_inclusion() {
    functions_are_monotone::<Rigorous>();
    functions_are_monotone::<Fast>();
}

#[test]
fn the_kernels_agree() {
    let mut random = Random(seed(5));
    for _ in 0..cases(CASES) {
        let x = some_interval(&mut random);
        for f in Function::ALL {
            let (rigorous, fast) = (f.of(x), f.of(x.with_kernel::<Fast>()).with_kernel());
            assert_eq!(rigorous.is_undefined(), fast.is_undefined(), "{f:?}: {x:?}");
            assert!(rigorous.intersection(fast).is_some(), "{f:?}: {x:?} {rigorous:?} {fast:?}");
        }
    }
}

#[test]
fn sums_and_products_of_dyadics_are_exact() {
    let mut random = Random(seed(6));
    let mut sum = Interval::point(0.0);
    for _ in 0..cases(CASES) {
        let mut short = || (random.bits() % (1 << 21)) as f64 / 1024.0 - 1000.0;
        let (a, b) = (short(), short());
        let (x, y) = (Interval::point(a), Interval::point(b));
        assert_eq!(x * y + 0.125, Interval::point(a * b + 0.125));
        assert_eq!(x.sqr() - y, Interval::point(a * a - b));
        sum += x;
    }
    assert_eq!(sum.width(), 0.0);
    assert_eq!(Interval::point(21.0) / 7.0, Interval::point(3.0));
    assert!((Interval::point(1.0) / 3.0).width() > 0.0);
    assert!((Interval::point(0.1) + 0.2).width() > 0.0);
}
