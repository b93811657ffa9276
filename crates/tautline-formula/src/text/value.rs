//! `Value`: the value of an expression in a text.

use std::ops::{Add, Div, Mul, Neg, Sub};

use tautline_scalar::{Interval, Scalar};

use crate::{operation::Arithmetic, recording::Symbol};

/// The value of an expression.
///
/// The operators between numbers give a number where they are exact, and otherwise a step, whose rounding
/// intervals enclose. So nobody relies on a derivative that is 0 or 1 by rounding.
#[derive(Clone, Copy)]
pub(super) enum Value {
    Number(f64),
    /// A number typed as arithmetic between numbers, such as `2*pi/3`.
    Rounded(Rounded),
    Symbol(Symbol),
}

/// A number that differs from what was typed in its last digits.
#[derive(Clone, Copy)]
pub(super) struct Rounded {
    pub(super) value: f64,
    /// Bounds on what was typed.
    pub(super) within: Interval,
    /// The same as steps, for arithmetic that loses more digits.
    pub(super) steps: Symbol,
}

impl Value {
    /// Returns the value as a step.
    pub(super) fn symbol(self) -> Symbol {
        match self {
            Value::Number(value) | Value::Rounded(Rounded { value, .. }) => Symbol::constant(value),
            Value::Symbol(symbol) => symbol,
        }
    }

    /// Returns the value if it is a number.
    pub(super) fn number(self) -> Option<f64> {
        match self {
            Value::Number(value) | Value::Rounded(Rounded { value, .. }) => Some(value),
            Value::Symbol(_) => None,
        }
    }

    /// Returns the value, from now on without what it was before it was rounded.
    pub(super) fn settled(self) -> Self {
        self.number().map_or(self, Value::Number)
    }

    /// Returns whether it is this number, and not a step.
    pub(super) fn is(self, number: f64) -> bool {
        matches!(self, Value::Number(value) if value == number)
    }

    /// Returns the square.
    pub(super) fn squared(self) -> Self {
        let square = self.number().and_then(|a| exact(Arithmetic::Mul, a, a));
        square.map_or_else(|| Value::Symbol(self.symbol().sqr()), Value::Number)
    }
}

impl Neg for Value {
    type Output = Self;
    fn neg(self) -> Self {
        match self {
            Value::Number(value) => Value::Number(-value),
            Value::Rounded(Rounded { value, within, steps }) => {
                Value::Rounded(Rounded { value: -value, within: -within, steps: -steps })
            }
            Value::Symbol(value) => Value::Symbol(-value),
        }
    }
}

macro_rules! arithmetic {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Value {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                match (self.number(), other.number()) {
                    (Some(a), Some(b)) => exact(Arithmetic::$operator, a, b)
                        .map_or_else(|| Value::Symbol(Symbol::constant(a).$method(b)), Value::Number),
                    (Some(a), None) => Value::Symbol(a.$method(other.symbol())),
                    (None, Some(b)) => Value::Symbol(self.symbol().$method(b)),
                    (None, None) => Value::Symbol(self.symbol().$method(other.symbol())),
                }
            }
        }
    )*};
}

arithmetic!(Add add Sub sub Mul mul Div div);

/// Below this size a product may have digits that no double has: `2⁻⁹⁶⁰`.
const SMALL: f64 = f64::from_bits((1023 - 960) << 52);

/// Returns the result of an operation if it is the exact one.
///
/// A sum `s` of `a` and `b` is exact if neither `s − a` differs from `b` nor `s − b` from `a`: one of the two
/// differences is exact. The remainder of a product or a quotient is a double unless it is below the
/// smallest one.
fn exact(how: Arithmetic, a: f64, b: f64) -> Option<f64> {
    let y = how.of(a, b);
    let is_exact = match how {
        Arithmetic::Add => y - a == b && y - b == a,
        Arithmetic::Sub => a - y == b && y + b == a,
        Arithmetic::Mul if a == 0.0 || b == 0.0 => a.is_finite() && b.is_finite(),
        Arithmetic::Mul => y.abs() >= SMALL && a.mul_add(b, -y) == 0.0,
        Arithmetic::Div if a == 0.0 => b != 0.0 && b.is_finite(),
        Arithmetic::Div => a.abs() >= SMALL && y.abs() >= SMALL && y.mul_add(b, -a) == 0.0,
    };
    (is_exact && y.is_finite()).then_some(y)
}
