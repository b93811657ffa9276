//! Elementary functions to 192 bits by `astro-float`, which shares no code with ours, and the
//! comparison of an enclosure with them.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

use astro_float::{BigFloat, Consts, RoundingMode};
use tautline_scalar::{Enclosure, Fast, Kernel, Rigorous, Scalar};

/// The precision, in bits. What the library is off by, some units of the last of these places, is
/// less than `10⁻⁴⁰` of a double's place.
const P: usize = 192;
const RM: RoundingMode = RoundingMode::None;

/// Reproducible numbers: Steele, Lea and Flood's SplitMix64.
#[derive(Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// A positive number with an exponent between the two, evenly.
    pub(crate) fn with_exponent(&mut self, least: i32, most: i32) -> f64 {
        let e = least + (self.bits() % u64::from((most - least).unsigned_abs() + 1)) as i32;
        let m = 1.0 + self.unit();
        // In two steps, since 2^e alone may underflow where the product does not.
        m * 2.0_f64.powi(e / 2) * 2.0_f64.powi(e - e / 2)
    }

    pub(crate) fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }
}

/// One elementary function, with the range in which it is tried.
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

/// The functions that share one computation in high precision.
pub(crate) const FAMILIES: [&[Function]; 4] =
    [&[Exp, Sinh, Cosh, Tanh], &[Ln], &[Sin, Cos, Tan], &[Atan]];

impl Function {
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

/// An argument of the family: half in the range where it is used, half with any exponent.
pub(crate) fn argument(family: &[Function], random: &mut Random) -> f64 {
    let moderate = random.bits() & 1 == 0;
    let sign = random.sign();
    match family[0] {
        Exp if moderate => random.between(-50.0, 50.0),
        Exp => sign * random.with_exponent(-300, 8) * random.between(1.0, 1.4),
        Ln if moderate => random.between(0.0, 10.0),
        Ln => random.with_exponent(-1022, 1023),
        Sin if moderate => random.between(-20.0, 20.0),
        Sin => sign * random.with_exponent(-300, 19),
        _ if moderate => random.between(-20.0, 20.0),
        _ => sign * random.with_exponent(-300, 300),
    }
}

/// The values of a family at an argument, in high precision.
pub(crate) struct Reference(Consts);

impl Reference {
    pub(crate) fn new() -> Self {
        Self(Consts::new().expect("memory for the constants"))
    }

    /// The number `x`, exactly. Not at once where it is subnormal: version 0.9.6 of the library is
    /// then wrong by a factor of two.
    pub(crate) fn big(x: f64) -> BigFloat {
        if x.abs() >= f64::MIN_POSITIVE || x == 0.0 {
            return BigFloat::from_f64(x, P);
        }
        let (up, down) = (2.0_f64.powi(200), 2.0_f64.powi(-200));
        BigFloat::from_f64(x * up, P).mul(&BigFloat::from_f64(down, P), P, RM)
    }

    /// The values of the family at `x`.
    ///
    /// Where a value is closer to a double than `2⁻¹⁵⁰` of it, 192 bits may not tell on which side
    /// it is. But the side is known, and no other double is near: the number at `2⁻¹⁵⁰` of the
    /// double on that side is then as good, since it lies in the same intervals.
    pub(crate) fn values(&mut self, family: &[Function], x: f64) -> Vec<BigFloat> {
        let little = 2.0_f64.powi(-150);
        let beside = |y: f64, side: f64| {
            let part = Self::big(side * little).mul(&Self::big(y), P, RM);
            Self::big(y).add(&part, P, RM)
        };
        if x != 0.0 && x.abs() < 2.0_f64.powi(-75) {
            // Signs of the first terms left out: x³, or x for `exp`, or x².
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
                // The sum of the exponentials may round to less than 1.
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

/// Whether the number lies between the ends; not if the interval is undefined.
pub(crate) fn holds<K: Kernel>(x: Enclosure<K>, y: &BigFloat) -> bool {
    let below = |a: &BigFloat, b: &BigFloat| a.cmp(b).is_some_and(|order| order <= 0);
    !x.is_undefined()
        && (x.lo() == f64::NEG_INFINITY || below(&Reference::big(x.lo()), y))
        && (x.hi() == f64::INFINITY || below(y, &Reference::big(x.hi())))
}

/// The widest enclosures seen, in units of `2⁻⁵²` of the magnitude and absolutely.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Widest {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

/// Tries one argument, as a point and within two intervals, with both kernels; returns the widths
/// of the rigorous enclosures of the points.
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
        // A logarithm of a negative number is undefined, so nothing to compare with.
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
    // Overflow and subnormals apart: there a place is not relative.
    if y.is_finite() && size > 1e-290 {
        widest.relative = widest.relative.max(y.width() / size / f64::EPSILON);
        widest.absolute = widest.absolute.max(y.width() / f64::EPSILON);
    }
}

#[track_caller]
fn check<K: Kernel>(f: Function, lo: f64, hi: f64, x: f64, value: &BigFloat) {
    let argument = Enclosure::<K>::new(lo, hi).expect("ordered ends");
    let y = f.of(argument);
    // The tangent may be undefined only beyond the bound of the angles, or if a pole is near, at
    // about 1/|tan x|; never of a point.
    if f == Tan && y.is_undefined() && argument.magnitude() > 1_048_576.0 {
        return;
    }
    let steepness = f.of(Enclosure::<K>::point(x)).magnitude();
    if f == Tan && y.is_undefined() && (hi - lo > 1.0 || steepness * (hi - lo) > 0.5) {
        return;
    }
    assert!(holds(y, value), "{f:?}([{lo:e}, {hi:e}]) = {y:?} misses {value} at {x:e}");
}
