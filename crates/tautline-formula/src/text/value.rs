//! `Value`: the value of an expression in a text.

use std::ops::{Add, Div, Mul, Neg, Sub};

use tautline_scalar::Scalar;

use crate::{operation::Function, recording::Symbol};

/// The value of an expression. Arithmetic between numbers gives numbers.
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

    /// Returns whether it is this number, and not a step.
    pub(super) fn is(self, number: f64) -> bool {
        matches!(self, Value::Number(value) if value == number)
    }

    /// Returns the square.
    pub(super) fn squared(self) -> Self {
        self.under(Function::Sqr)
    }

    /// Returns the power.
    pub(super) fn powi(self, n: i32) -> Self {
        match self {
            Value::Number(a) => Value::Number(a.powi(n)),
            Value::Symbol(a) => Value::Symbol(a.powi(n)),
        }
    }

    /// Returns `f(x)`.
    pub(super) fn under(self, function: Function) -> Self {
        match self {
            Value::Number(value) => Value::Number(function.of(value)),
            Value::Symbol(value) => Value::Symbol(function.of(value)),
        }
    }
}

impl Neg for Value {
    type Output = Self;
    fn neg(self) -> Self {
        self.under(Function::Neg)
    }
}

macro_rules! arithmetic {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Value {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                match (self, other) {
                    (Value::Number(a), Value::Number(b)) => Value::Number(a.$method(b)),
                    (Value::Number(a), Value::Symbol(b)) => Value::Symbol(a.$method(b)),
                    (Value::Symbol(a), Value::Number(b)) => Value::Symbol(a.$method(b)),
                    (Value::Symbol(a), Value::Symbol(b)) => Value::Symbol(a.$method(b)),
                }
            }
        }
    )*};
}

arithmetic!(Add add Sub sub Mul mul Div div);
