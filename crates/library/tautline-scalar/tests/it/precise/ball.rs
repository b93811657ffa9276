//! `Value`: a real number to 192 bits with an error bound, or *undefined*.
//!
//! Without the bound, cancellation in the reference would look like an error of the enclosure:
//! `1 − tanh 70` is `2⁻²⁰⁰`, which 192 bits of `tanh` do not resolve.

use std::cell::RefCell;

use astro_float::{BigFloat, Consts, RoundingMode};

use crate::reference::Reference;

/// The precision of the centre in bits.
pub(super) const P: usize = 192;
/// The precision of the radius, which is rounded up.
const COARSE: usize = 64;
const EVEN: RoundingMode = RoundingMode::ToEven;
const UP: RoundingMode = RoundingMode::Up;

/// The real numbers within `radius` of `centre`.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    pub(crate) centre: BigFloat,
    pub(crate) radius: BigFloat,
}

/// What is known about the value of a formula at a point.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// The value lies in the ball.
    Within(Ball),
    /// There is no value: a division by zero, the root of a negative number and so on.
    Undefined,
    /// The precision does not suffice: the ball crosses the boundary of a domain or has hardly any
    /// correct digits, or a number exceeds the exponent range of the library.
    Unknown,
}

use Value::{Undefined, Unknown, Within};

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory"));
}

fn zero() -> BigFloat {
    BigFloat::new(COARSE)
}

/// The least binary exponent in use. The least exponent of the library is `−2³¹`.
const LEAST: i32 = -(1 << 26);

/// Returns `2ⁿ` with an `n` slightly above [`LEAST`].
fn hardly_anything() -> BigFloat {
    let mut bound = BigFloat::from_word(1, COARSE);
    bound.set_exponent(LEAST + 2);
    bound
}

/// Returns whether `a ≤ b`; false for NaN.
pub(super) fn at_most(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order <= 0)
}

/// Returns `2ⁿ x`, rounded up, for `x ≥ 0`.
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
    /// Returns the ball that contains only `x`.
    pub(super) fn exact(x: BigFloat) -> Self {
        Self { centre: x, radius: zero() }
    }

    fn is_exact(&self) -> bool {
        self.radius.is_zero()
    }

    /// Returns whether the ball contains only the number 0.
    pub(crate) fn is_zero(&self) -> bool {
        self.centre.is_zero() && self.is_exact()
    }

    /// Returns whether all numbers in the ball have the same sign, with twenty bits to spare. If
    /// so, the terms of higher order in the radii below are less than half of those of first order.
    fn is_clear(&self) -> bool {
        !self.centre.is_zero() && at_most(&scaled(&self.radius, 20), &self.centre.abs())
    }

    /// Returns whether the numbers in the ball differ by less than a millionth.
    fn is_small(&self) -> bool {
        at_most(&scaled(&self.radius, 20), &Reference::big(1.0))
    }

    /// Returns whether the absolute value of the centre is at least `2ⁿ`.
    fn is_beyond(&self, n: i32) -> bool {
        self.centre.exponent().is_none_or(|e| e > n)
    }

    /// Returns the result of an operation. It is given the computed centre, which is rounded unless
    /// it is marked as exact, and the radius that follows from the radii of the operands. Rounding
    /// to nearest has a relative error of `2⁻¹⁹²`; `2⁻¹⁸⁸` allows the library fifteen units more,
    /// and covers higher orders of the radii.
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
            // This is well before the library underflows to zero.
            let centre = if of_centre < LEAST { BigFloat::new(P) } else { centre };
            return Self::result(centre, plus(&radius, &hardly_anything()));
        }
        let rounded = centre.inexact();
        centre.set_inexact(false);
        let unit = if rounded { scaled(&centre.abs(), -188) } else { zero() };
        Within(Self { radius: plus(&radius, &unit), centre })
    }

    /// Returns the result of a function that does not report exactness.
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

    /// `|a′/b′ − q| = |a′ − q b′|/|b′| ≤ (r + |q| s)/|b′|` for `q = a/b` and radii `r` and `s`.
    /// For `|b′| ≥ |b|/2` this is at most `2 (r + |q| s)/|b|`.
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

    /// `|eˣ′ − eˣ| ≤ eˣ (eʳ − 1) ≤ 2 r eˣ`. The same holds for `sinh` and `cosh`, with `cosh x` for
    /// `eˣ`.
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

    /// Neither function exceeds 1 in absolute value or slope. Beyond the range of doubles, only
    /// this is used: there the library would need as many digits of `π` as the number has.
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

    /// The slope is at most 1 everywhere.
    pub(super) fn atan(&self) -> Value {
        if self.is_zero() {
            return Within(self.clone());
        }
        let angle = CONSTANTS.with_borrow_mut(|c| self.centre.atan(P, EVEN, c));
        Self::approximate(angle, self.radius.clone())
    }

    /// Returns whether the whole ball lies below `x`.
    pub(super) fn is_below(&self, x: f64) -> bool {
        !at_most(&Reference::big(x), &self.centre.add(&self.radius, P + COARSE, UP))
    }

    /// Returns whether the whole ball lies above `x`.
    pub(super) fn is_above(&self, x: f64) -> bool {
        self.negative().is_below(-x)
    }
}

impl Value {
    /// Applies `f` if there is a value.
    pub(super) fn then(&self, f: impl FnOnce(&Ball) -> Value) -> Self {
        match self {
            Within(x) => f(x),
            other => other.clone(),
        }
    }

    /// Applies `f` if there are two values. If one is undefined and the other unknown, the result
    /// is undefined.
    pub(super) fn with(&self, other: &Self, f: impl FnOnce(&Ball, &Ball) -> Value) -> Self {
        match (self, other) {
            (Within(x), Within(y)) => f(x, y),
            (Undefined, _) | (_, Undefined) => Undefined,
            _ => Unknown,
        }
    }
}
