//! `Value`: a real number to 192 bits with a bound of the error, or the mark that there is none.
//!
//! Without the bound a formula that cancels would be blamed on the enclosure: `1 − tanh 70` is
//! `2⁻²⁰⁰`, of which 192 bits of the hyperbolic tangent know nothing.

use std::cell::RefCell;

use astro_float::{BigFloat, Consts, RoundingMode};

use crate::reference::Reference;

/// The precision of the centre, in bits; that of the radius is enough to round it up.
pub(super) const P: usize = 192;
const COARSE: usize = 64;
const EVEN: RoundingMode = RoundingMode::ToEven;
const UP: RoundingMode = RoundingMode::Up;

/// The real numbers at a distance of at most `radius` from `centre`.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    pub(crate) centre: BigFloat,
    pub(crate) radius: BigFloat,
}

/// What is known of the value of a formula at a point.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// It lies in the ball.
    Within(Ball),
    /// There is none: a zero divides, a negative number has a root taken of it, and so on.
    Undefined,
    /// The precision does not tell: a ball that reaches over the edge of a domain or has hardly a
    /// digit, or a number beyond the exponents of the library.
    Unknown,
}

use Value::{Undefined, Unknown, Within};

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory"));
}

fn zero() -> BigFloat {
    BigFloat::new(COARSE)
}

/// The least binary exponent; that of the library is `−2³¹`.
const LEAST: i32 = -(1 << 26);

/// `2ⁿ` with an `n` somewhat above [`LEAST`], which bounds every smaller number.
fn hardly_anything() -> BigFloat {
    let mut bound = BigFloat::from_word(1, COARSE);
    bound.set_exponent(LEAST + 2);
    bound
}

/// Whether `a ≤ b`; not if either is NaN.
pub(super) fn at_most(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order <= 0)
}

/// `2ⁿ x`, rounded up; for `x ≥ 0`.
fn scaled(x: &BigFloat, n: i32) -> BigFloat {
    x.mul(&Reference::big(2.0_f64.powi(n)), COARSE, UP)
}

fn plus(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.add(b, COARSE, UP)
}

fn times(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.abs().mul(&b.abs(), COARSE, UP)
}

impl Ball {
    /// The one number `x`.
    pub(super) fn exact(x: BigFloat) -> Self {
        Self { centre: x, radius: zero() }
    }

    fn is_exact(&self) -> bool {
        self.radius.is_zero()
    }

    /// Whether zero is the only number in it.
    pub(crate) fn is_zero(&self) -> bool {
        self.centre.is_zero() && self.is_exact()
    }

    /// Whether it has the sign of its centre throughout, with twenty bits to spare: then the terms
    /// of higher order of the radii below are less than half of those of the first.
    fn is_clear(&self) -> bool {
        !self.centre.is_zero() && at_most(&scaled(&self.radius, 20), &self.centre.abs())
    }

    /// Whether its numbers differ by less than a millionth.
    fn is_small(&self) -> bool {
        at_most(&scaled(&self.radius, 20), &Reference::big(1.0))
    }

    /// Whether the centre is at least `2ⁿ` in size.
    fn is_beyond(&self, n: i32) -> bool {
        self.centre.exponent().is_none_or(|e| e > n)
    }

    /// The result of an operation: the computed centre, rounded unless it is marked as exact, and
    /// what becomes of the radii of the operands. Rounded to nearest the centre is off by `2⁻¹⁹²`
    /// of it; `2⁻¹⁸⁸` forgives the library fifteen units, and the higher orders of the radii.
    fn result(mut centre: BigFloat, radius: BigFloat) -> Value {
        let exponents =
            [&centre, &radius].map(|x| if x.is_zero() { Some(0) } else { x.exponent() });
        let [Some(of_centre), Some(of_radius)] = exponents else {
            return Unknown;
        };
        if of_centre > -LEAST {
            return Unknown;
        }
        if of_centre < LEAST || of_radius < LEAST {
            // Far from the end of the exponents, where something might become zero.
            let centre = if of_centre < LEAST { BigFloat::new(P) } else { centre };
            return Self::result(centre, plus(&radius, &hardly_anything()));
        }
        let rounded = centre.inexact();
        centre.set_inexact(false);
        let unit = if rounded { scaled(&centre.abs(), -188) } else { zero() };
        Within(Self { radius: plus(&radius, &unit), centre })
    }

    /// The result of a function that does not say whether it is exact: then it is not.
    fn approximate(mut centre: BigFloat, radius: BigFloat) -> Value {
        centre.set_inexact(true);
        Self::result(centre, radius)
    }

    pub(super) fn negative(&self) -> Self {
        Self { centre: self.centre.neg(), radius: self.radius.clone() }
    }

    pub(super) fn add(&self, other: &Self) -> Value {
        let radius = plus(&self.radius, &other.radius);
        Self::result(self.centre.add(&other.centre, P, EVEN), radius)
    }

    /// `|a′ b′ − a b| ≤ |a| s + |b| r + r s` for radii `r` and `s`.
    pub(super) fn mul(&self, other: &Self) -> Value {
        let ((a, r), (b, s)) = ((&self.centre, &self.radius), (&other.centre, &other.radius));
        let product = a.mul(b, P, EVEN);
        if self.is_exact() && other.is_exact() {
            return Self::result(product, zero());
        }
        Self::result(product, plus(&plus(&times(a, s), &times(b, r)), &times(r, s)))
    }

    /// `|a′/b′ − q| = |a′ − q b′|/|b′| ≤ (r + |q| s)/|b′|` for `q = a/b`, radii `r` and `s`; twice
    /// that for `|b′| ≥ |b|/2`.
    pub(super) fn div(&self, other: &Self) -> Value {
        if other.is_zero() {
            return Undefined;
        }
        if !other.is_clear() {
            return Unknown;
        }
        let quotient = self.centre.div(&other.centre, P, EVEN);
        let sum = plus(&self.radius, &times(&quotient, &other.radius));
        let radius = scaled(&sum, 1).div(&other.centre.abs(), COARSE, UP);
        Self::result(quotient, radius)
    }

    /// `|√x′ − √x| ≤ r/√x`.
    pub(super) fn sqrt(&self) -> Value {
        if self.is_zero() {
            return Within(self.clone());
        }
        if !self.is_clear() {
            return Unknown;
        }
        if self.centre.is_negative() {
            return Undefined;
        }
        let mut root = self.centre.sqrt(P, EVEN);
        let square = root.mul(&root, 2 * P, EVEN);
        root.set_inexact(square.cmp(&self.centre) != Some(0));
        let radius = scaled(&self.radius, 1).div(&root, COARSE, UP);
        Self::result(root, radius)
    }

    /// `|ln x′ − ln x| ≤ r/(x − r) ≤ 2 r/x`.
    pub(super) fn ln(&self) -> Value {
        if self.is_zero() {
            return Undefined;
        }
        if !self.is_clear() {
            return Unknown;
        }
        if self.centre.is_negative() {
            return Undefined;
        }
        let radius = scaled(&self.radius, 1).div(&self.centre, COARSE, UP);
        let ln = CONSTANTS.with_borrow_mut(|c| self.centre.ln(P, EVEN, c));
        if ln.is_zero() { Self::result(ln, radius) } else { Self::approximate(ln, radius) }
    }

    /// `|eˣ′ − eˣ| ≤ eˣ (eʳ − 1) ≤ 2 r eˣ`; also for `sinh` and `cosh`, with `cosh x` for `eˣ`.
    pub(super) fn exp(&self) -> Value {
        if self.is_zero() {
            return Within(Self::exact(Reference::big(1.0)));
        }
        // e^{−2²⁶} < 2^{−2²⁶}.
        if self.is_below(f64::from(LEAST)) {
            return Within(Self { centre: BigFloat::new(P), radius: hardly_anything() });
        }
        if !self.is_small() || self.is_beyond(27) {
            return Unknown;
        }
        let e = CONSTANTS.with_borrow_mut(|c| self.centre.exp(P, EVEN, c));
        let radius = scaled(&times(&e, &self.radius), 1);
        Self::approximate(e, radius)
    }

    pub(super) fn sinh_cosh(&self) -> (Value, Value) {
        if self.is_zero() {
            return (Within(self.clone()), Within(Self::exact(Reference::big(1.0))));
        }
        if !self.is_small() || self.is_beyond(27) {
            return (Unknown, Unknown);
        }
        let (s, c) = CONSTANTS.with_borrow_mut(|constants| {
            (self.centre.sinh(P, EVEN, constants), self.centre.cosh(P, EVEN, constants))
        });
        let radius = scaled(&times(&c, &self.radius), 1);
        (Self::approximate(s, radius.clone()), Self::approximate(c, radius))
    }

    /// Neither is steeper than 1, nor larger: which is all that is said of the numbers beyond the
    /// doubles, where the library would need `π` to as many places as the number has.
    pub(super) fn sin_cos(&self) -> (Value, Value) {
        if self.is_zero() {
            return (Within(self.clone()), Within(Self::exact(Reference::big(1.0))));
        }
        if self.is_beyond(1024) {
            let any = Within(Self { centre: BigFloat::new(P), radius: Reference::big(1.0) });
            return (any.clone(), any);
        }
        let (s, c) = CONSTANTS.with_borrow_mut(|constants| {
            (self.centre.sin(P, EVEN, constants), self.centre.cos(P, EVEN, constants))
        });
        let radius = self.radius.clone();
        (Self::approximate(s, radius.clone()), Self::approximate(c, radius))
    }

    /// Nowhere steeper than 1.
    pub(super) fn atan(&self) -> Value {
        if self.is_zero() {
            return Within(self.clone());
        }
        let angle = CONSTANTS.with_borrow_mut(|c| self.centre.atan(P, EVEN, c));
        Self::approximate(angle, self.radius.clone())
    }

    /// Whether all of it lies below `x`.
    pub(super) fn is_below(&self, x: f64) -> bool {
        !at_most(&Reference::big(x), &self.centre.add(&self.radius, P + COARSE, UP))
    }

    /// Whether all of it lies above `x`.
    pub(super) fn is_above(&self, x: f64) -> bool {
        self.negative().is_below(-x)
    }
}

impl Value {
    /// The function of it, if there is a value. What is undefined stays so.
    pub(super) fn then(&self, f: impl FnOnce(&Ball) -> Value) -> Self {
        match self {
            Within(x) => f(x),
            other => other.clone(),
        }
    }

    /// The operation, if there are values. With the unknown the undefined is undefined.
    pub(super) fn with(&self, other: &Self, f: impl FnOnce(&Ball, &Ball) -> Value) -> Self {
        match (self, other) {
            (Within(x), Within(y)) => f(x, y),
            (Undefined, _) | (_, Undefined) => Undefined,
            _ => Unknown,
        }
    }
}
