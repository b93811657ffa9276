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
    Symbol(Symbol),
}

impl Value {
    /// Returns the value as a step.
    pub(super) fn symbol(self) -> Symbol {
        match self {
            Value::Number(value) => Symbol::constant(value),
            Value::Symbol(symbol) => symbol,
        }
    }

    /// Returns the value if it is a number.
    pub(super) fn number(self) -> Option<f64> {
        if let Value::Number(value) = self { Some(value) } else { None }
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

/// Returns the result of an operation if it is the exact one: intervals enclose it by a single double.
fn exact(how: Arithmetic, a: f64, b: f64) -> Option<f64> {
    let y = how.of(Interval::point(a), Interval::point(b));
    (y.lo() == y.hi()).then(|| y.lo())
}
