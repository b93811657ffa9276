//! Compares the functions with 192 bits, and checks values at and beyond the ends of the ranges.

use astro_float::{BigFloat, Consts, RoundingMode};

use super::sin_cos;

const P: usize = 192;
const RM: RoundingMode = RoundingMode::None;

type Exact = fn(&BigFloat, usize, RoundingMode, &mut Consts) -> BigFloat;

/// Returns the value at `x`, which must be the same in blocks of any size and at any place in them.
fn single(
    x: f64,
    of: impl Fn(&mut [f64; 8], &[f64; 8]),
    of_one: impl Fn(&mut [f64; 1], &[f64; 1]),
) -> f64 {
    let (mut block, mut one) = ([0.0; 8], [0.0]);
    of(&mut block, &[x, 0.5, -x, x, 1.0, 2.0, x, 0.25]);
    of_one(&mut one, &[x]);
    let same = [0, 3, 6].map(|place| block[place].to_bits());
    assert_eq!(same, [one[0].to_bits(); 3], "{x:e}");
    one[0]
}

macro_rules! single {
    ($($function:ident)*) => {$(
        fn $function(x: f64) -> f64 {
            single(x, super::$function, super::$function)
        }
    )*};
}

single!(atan cosh exp ln tanh);

fn sin(x: f64) -> f64 {
    single(x, |y, x| sin_cos(y, &mut [0.0; 8], x), |y, x| sin_cos(y, &mut [0.0], x))
}

fn cos(x: f64) -> f64 {
    single(x, |y, x| sin_cos(&mut [0.0; 8], y, x), |y, x| sin_cos(&mut [0.0], y, x))
}

/// Numbers that fill an interval, evenly or by their exponents.
#[derive(Debug)]
enum Numbers {
    Even(f64, f64),
    Geometric(f64, f64),
}
use Numbers::{Even, Geometric};

impl Numbers {
    /// Returns fractional parts of multiples of the golden ratio.
    fn all(&self) -> impl Iterator<Item = f64> {
        let (lo, hi, is_even) = match *self {
            Even(lo, hi) => (lo, hi, true),
            Geometric(lo, hi) => (lo.ln(), hi.ln(), false),
        };
        (1..=2000_u32).map(move |i| {
            let x = lo + (hi - lo) * (f64::from(i) * 0.618_033_988_749_895).fract();
            if is_even { x } else { x.exp() }
        })
    }
}

/// Each row has the function, its exact value, the largest error in units in the last place, the
/// least value whose unit is used, and the arguments. At least one error must reach 0.4 of the
/// bound.
#[test]
fn errors_are_as_stated() {
    type Row = (&'static str, fn(f64) -> f64, Exact, f64, f64, Numbers);
    #[rustfmt::skip]
    let rows: [Row; 20] = [
        ("atan", atan, BigFloat::atan, 1.0, 0.0, Even(-0.7, 0.7)),
        ("atan", atan, BigFloat::atan, 1.0, 0.0, Even(-6.0, 6.0)),
        ("atan", atan, BigFloat::atan, 1.0, 0.0, Geometric(1e-20, 1e20)),
        ("sin", sin, BigFloat::sin, 2.0, 1e-8, Even(-0.8, 0.8)),
        ("sin", sin, BigFloat::sin, 2.0, 1e-8, Even(-20.0, 20.0)),
        ("sin", sin, BigFloat::sin, 2.0, 1e-8, Even(-1e6, 1e6)),
        ("cos", cos, BigFloat::cos, 2.0, 1e-8, Even(-0.8, 0.8)),
        ("cos", cos, BigFloat::cos, 2.0, 1e-8, Even(-20.0, 20.0)),
        ("cos", cos, BigFloat::cos, 2.0, 1e-8, Even(-1e6, 1e6)),
        ("exp", exp, BigFloat::exp, 1.0, 0.0, Even(-0.35, 0.35)),
        ("exp", exp, BigFloat::exp, 1.0, 0.0, Even(-20.0, 20.0)),
        ("exp", exp, BigFloat::exp, 1.0, 0.0, Even(-600.0, 709.0)),
        ("tanh", tanh, BigFloat::tanh, 2.0, 0.0, Even(-0.7, 0.7)),
        ("tanh", tanh, BigFloat::tanh, 2.0, 0.0, Even(-4.0, 4.0)),
        ("tanh", tanh, BigFloat::tanh, 1.0, 0.0, Geometric(1e-20, 0.6)),
        ("cosh", cosh, BigFloat::cosh, 2.0, 0.0, Even(-4.0, 4.0)),
        ("cosh", cosh, BigFloat::cosh, 2.0, 0.0, Even(-700.0, 700.0)),
        ("ln", ln, BigFloat::ln, 1.0, 0.0, Even(0.6, 1.6)),
        ("ln", ln, BigFloat::ln, 1.0, 0.0, Even(0.999, 1.001)),
        ("ln", ln, BigFloat::ln, 0.75, 0.0, Geometric(1e-300, 1e300)),
    ];
    let mut constants = Consts::new().expect("memory");
    for (name, of, exact, ulp, least, numbers) in rows {
        let mut most = 0.0_f64;
        for x in numbers.all() {
            let y = of(x);
            let unit = y.abs().max(least).next_up() - y.abs().max(least);
            let exact = exact(&BigFloat::from_f64(x, P), P, RM, &mut constants);
            let error = exact.sub(&BigFloat::from_f64(y, P), P, RM).abs().to_string();
            let units = error.parse::<f64>().expect("a number") / unit;
            assert!(units <= ulp, "{name} at {x:e}: {y:e} is off by {units} units");
            most = most.max(units);
        }
        assert!(most > 0.4 * ulp, "{name} on {numbers:?}: at most {most} units");
    }
}

#[test]
fn beyond_their_ranges_and_at_zero_they_are_the_standard_library() {
    type Row = (&'static str, fn(f64) -> f64, fn(f64) -> f64, &'static [f64]);
    const INF: f64 = f64::INFINITY;
    const NAN: f64 = f64::NAN;
    let large = [1e6_f64.next_up(), -1e300, INF, NAN, 0.0, -0.0];
    #[rustfmt::skip]
    let rows: [Row; 5] = [
        ("atan", atan, f64::atan, &[NAN, 0.0, -0.0]),
        ("tanh", tanh, f64::tanh, &[NAN, 0.0, -0.0]),
        ("exp", exp, f64::exp, &[-708.5, -750.0, 709.5, 800.0, INF, -INF, NAN, 0.0, -0.0]),
        ("cosh", cosh, f64::cosh, &[700.5, -800.0, INF, NAN, 0.0, -0.0]),
        ("ln", ln, f64::ln, &[0.0, -0.0, -1.0, 5e-324, INF, -INF, NAN, 1.0]),
    ];
    let same = |name, x: f64, found: f64, expected: f64| {
        let is_same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
        assert!(is_same, "{name} at {x:e}: {found:e} for {expected:e}");
    };
    for (name, of, standard, xs) in rows {
        xs.iter().for_each(|&x| same(name, x, of(x), standard(x)));
    }
    for x in large {
        same("sin", x, sin(x), x.sin());
        same("cos", x, cos(x), x.cos());
    }
    for x in [1e17, 1e300, INF] {
        let quarter = std::f64::consts::FRAC_PI_2;
        assert_eq!((atan(x), atan(-x)), (quarter, -quarter), "{x}");
    }
    for x in [20.0, 22.0, 30.0, 1e300, INF] {
        assert_eq!((tanh(x), tanh(-x)), (1.0, -1.0), "{x}");
    }
    for x in [f64::MIN_POSITIVE, f64::MAX, 2.0, 0.5] {
        assert!((ln(x) / x.ln() - 1.0).abs() <= 2.0 * f64::EPSILON, "{x:e}");
    }
}
