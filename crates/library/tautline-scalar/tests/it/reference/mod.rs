//! Elementary functions computed to 192 bits by `astro-float`, which shares no code with ours, and
//! comparisons of enclosures with them.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

pub(crate) use tautline_chance::Random;

use astro_float::{BigFloat, Consts, RoundingMode};
use tautline_scalar::{Enclosure, Fast, Kernel, Rigorous, Scalar};

/// The precision in bits. The error of the library is a few units in the last place, which is less
/// than `10⁻⁴⁰` ulps of a double.
const P: usize = 192;
const RM: RoundingMode = RoundingMode::None;

/// An elementary function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Function {
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Atan,
    Sinh,
    Cosh,
    Tanh,
}

use Function::{Atan, Cos, Cosh, Exp, Ln, Sin, Sinh, Tan, Tanh};

/// Functions that share one computation in high precision.
pub(crate) const FAMILIES: [&[Function]; 4] =
    [&[Exp, Sinh, Cosh, Tanh], &[Ln], &[Sin, Cos, Tan], &[Atan]];

impl Function {
    pub(crate) const ALL: [Self; 9] = [Exp, Ln, Sin, Cos, Tan, Atan, Sinh, Cosh, Tanh];

    pub(crate) fn of<S: Scalar>(self, x: S) -> S {
        match self {
            Exp => x.exp(),
            Ln => x.ln(),
            Sin => x.sin(),
            Cos => x.cos(),
            Tan => x.tan(),
            Atan => x.atan(),
            Sinh => x.sinh(),
            Cosh => x.cosh(),
            Tanh => x.tanh(),
        }
    }
}

/// Returns an argument for the family: half of them of moderate size, half with any exponent.
pub(crate) fn argument(family: &[Function], random: &mut Random) -> f64 {
    let moderate = random.bits() & 1 == 0;
    let sign = random.sign();
    match family[0] {
        Exp if moderate => random.between(-50.0, 50.0),
        Exp => sign * random.with_exponent(-300, 8) * random.between(1.0, 1.4),
        Ln if moderate => random.between(0.0, 10.0),
        Ln => random.with_exponent(-1022, 1023),
        Sin if moderate => random.between(-20.0, 20.0),
        Sin => sign * random.with_exponent(-300, 37),
        _ if moderate => random.between(-20.0, 20.0),
        _ => sign * random.with_exponent(-300, 300),
    }
}

/// Computes the reference values.
pub(crate) struct Reference(Consts);

impl Reference {
    pub(crate) fn new() -> Self {
        Self(Consts::new().expect("memory for the constants"))
    }

    /// Returns the number `x`, exactly. A subnormal number is converted in two steps, since version
    /// 0.9.6 of the library would be wrong by a factor of two.
    pub(crate) fn big(x: f64) -> BigFloat {
        if x.abs() >= f64::MIN_POSITIVE || x == 0.0 {
            return BigFloat::from_f64(x, P);
        }
        let (up, down) = (2.0_f64.powi(200), 2.0_f64.powi(-200));
        BigFloat::from_f64(x * up, P).mul(&BigFloat::from_f64(down, P), P, RM)
    }

    /// Returns the values of the family at `x`.
    ///
    /// If the relative distance of a value from a double is less than `2⁻¹⁵⁰`, 192 bits may not
    /// decide on which side of the double it lies. Theory does decide, and no other double is near.
    /// The number at the relative distance `2⁻¹⁵⁰` on that side lies in the same intervals, so it
    /// replaces the value.
    pub(crate) fn values(&mut self, family: &[Function], x: f64) -> Vec<BigFloat> {
        let little = 2.0_f64.powi(-150);
        let beside = |y: f64, side: f64| {
            let part = Self::big(side * little).mul(&Self::big(y), P, RM);
            Self::big(y).add(&part, P, RM)
        };
        if x != 0.0 && x.abs() < 2.0_f64.powi(-75) {
            // The sign of the next term of the series decides: x for exp, x² for even functions, x³
            // for odd ones.
            let (less, more) = (beside(x, -1.0), beside(x, 1.0));
            return match family[0] {
                Exp => vec![beside(1.0, x.signum()), more, beside(1.0, 1.0), less],
                Sin => vec![less, beside(1.0, -1.0), more],
                Atan => vec![less],
                _ => vec![Self::big(x).ln(P, RM, &mut self.0)],
            };
        }
        let mut values = self.computed(family, x);
        if family[0] == Exp && x.abs() > 53.0 {
            // 2 e⁻¹⁰⁶ < 2⁻¹⁵⁰.
            values[3] = beside(x.signum(), -1.0);
        }
        values
    }

    fn computed(&mut self, family: &[Function], x: f64) -> Vec<BigFloat> {
        let x = Self::big(x);
        let small = x.abs().cmp(&Self::big(1.0)).is_some_and(|order| order < 0);
        match family[0] {
            Exp => {
                let e = x.exp(P, RM, &mut self.0);
                let r = e.reciprocal(P, RM);
                let half = Self::big(0.5);
                let sinh = if small {
                    x.sinh(P, RM, &mut self.0)
                } else {
                    e.sub(&r, P, RM).mul(&half, P, RM)
                };
                // The sum of the exponentials might round to less than 1.
                let cosh = if small {
                    let square = sinh.mul(&sinh, P, RM);
                    Self::big(1.0).add(&square, P, RM).sqrt(P, RM)
                } else {
                    e.add(&r, P, RM).mul(&half, P, RM)
                };
                let tanh = sinh.div(&cosh, P, RM);
                vec![e, sinh, cosh, tanh]
            }
            Ln => vec![x.ln(P, RM, &mut self.0)],
            Sin => {
                let s = x.sin(P, RM, &mut self.0);
                let c = x.cos(P, RM, &mut self.0);
                let t = s.div(&c, P, RM);
                vec![s, c, t]
            }
            _ => vec![x.atan(P, RM, &mut self.0)],
        }
    }
}

/// Returns whether `y` lies in `x`; false if `x` is undefined.
pub(crate) fn holds<K: Kernel>(x: Enclosure<K>, y: &BigFloat) -> bool {
    let below = |a: &BigFloat, b: &BigFloat| a.cmp(b).is_some_and(|order| order <= 0);
    !x.is_undefined()
        && (x.lo() == f64::NEG_INFINITY || below(&Reference::big(x.lo()), y))
        && (x.hi() == f64::INFINITY || below(y, &Reference::big(x.hi())))
}

/// The greatest widths in units of `2⁻⁵²`, both relative to the magnitude and absolute.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Widest {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

/// Checks the enclosures of a point and of two intervals around it, with both kernels. Records the
/// widths at the point in `widest`.
pub(crate) fn attempt(
    family: &[Function],
    x: f64,
    reference: &mut Reference,
    random: &mut Random,
    widest: &mut [[Widest; 2]],
) {
    let values = reference.values(family, x);
    let within = |random: &mut Random, f: Function| {
        let spread = if random.bits() & 1 == 0 { 1e-15 } else { 3.0 };
        let size = x.abs() * spread;
        let lo = x - size * random.unit();
        // The logarithm of an interval that contains a negative number is undefined.
        let lo = if f == Ln && !(lo > 0.0) { x } else { lo };
        (lo, (x + size * random.unit()).min(f64::MAX))
    };
    for ((&f, value), widest) in family.iter().zip(&values).zip(widest) {
        let ends = [(x, x), within(random, f), within(random, f)];
        for (lo, hi) in ends {
            check::<Rigorous>(f, lo, hi, x, value);
            check::<Fast>(f, lo, hi, x, value);
        }
        record(&mut widest[0], f.of(Enclosure::<Rigorous>::point(x)));
        record(&mut widest[1], f.of(Enclosure::<Fast>::point(x)));
    }
}

fn record<K: Kernel>(widest: &mut Widest, y: Enclosure<K>) {
    let size = y.magnitude();
    // Overflow and subnormal numbers, which have no relative precision, are excluded.
    if y.is_finite() && size > 1e-290 {
        widest.relative = widest.relative.max(y.width() / size / f64::EPSILON);
        widest.absolute = widest.absolute.max(y.width() / f64::EPSILON);
    }
}

#[track_caller]
fn check<K: Kernel>(f: Function, lo: f64, hi: f64, x: f64, value: &BigFloat) {
    let argument = Enclosure::<K>::new(lo, hi).expect("ordered ends");
    let y = f.of(argument);
    // The tangent may be undefined only beyond the largest angle, or if a pole is near, at a
    // distance of about 1/|tan x|. It is never undefined at a point.
    if f == Tan && y.is_undefined() && argument.magnitude() > 274_877_906_944.0 {
        return;
    }
    let steepness = f.of(Enclosure::<K>::point(x)).magnitude();
    if f == Tan && y.is_undefined() && (hi - lo > 1.0 || steepness * (hi - lo) > 0.5) {
        return;
    }
    assert!(holds(y, value), "{f:?}([{lo:e}, {hi:e}]) = {y:?} misses {value} at {x:e}");
}
