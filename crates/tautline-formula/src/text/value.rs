//! `Value`: what an expression of a text stands for.

use std::ops::{Add, Div, Mul, Neg, Sub};

use tautline_scalar::Scalar;

use crate::recording::Symbol;

/// The value of an expression: numbers among themselves stay numbers.
#[derive(Clone, Copy)]
pub(super) enum Value {
    Number(f64),
    Symbol(Symbol),
}

impl Value {
    /// The value as a step.
    pub(super) fn symbol(self) -> Symbol {
        match self {
            Value::Number(value) => Symbol::constant(value),
            Value::Symbol(symbol) => symbol,
        }
    }

    /// Whether it is this number, and no step.
    pub(super) fn is(self, number: f64) -> bool {
        matches!(self, Value::Number(value) if value == number)
    }

    /// The square.
    pub(super) fn squared(self) -> Self {
        match self {
            Value::Number(a) => Value::Number(a * a),
            Value::Symbol(a) => Value::Symbol(a.sqr()),
        }
    }

    /// The power; of a number in `f64`.
    pub(super) fn powi(self, n: i32) -> Self {
        match self {
            Value::Number(a) => Value::Number(a.powi(n)),
            Value::Symbol(a) => Value::Symbol(a.powi(n)),
        }
    }

    /// The value of a function; of a number in `f64`.
    pub(super) fn under(self, function: Function) -> Self {
        match (function, self) {
            (Function::Step, value) => Value::Symbol(value.symbol()),
            (Function::Of { number, .. }, Value::Number(value)) => Value::Number(number(value)),
            (Function::Of { symbol, .. }, Value::Symbol(value)) => Value::Symbol(symbol(value)),
        }
    }
}

impl Neg for Value {
    type Output = Self;
    fn neg(self) -> Self {
        match self {
            Value::Number(a) => Value::Number(-a),
            Value::Symbol(a) => Value::Symbol(-a),
        }
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

/// A function that a text may name.
pub(super) enum Function {
    /// `number`, which makes a step of a number.
    Step,
    /// What a number has for it, and what a step has.
    Of { number: fn(f64) -> f64, symbol: fn(Symbol) -> Symbol },
}

/// Returns the function of this name.
pub(super) fn function(name: &str) -> Option<Function> {
    macro_rules! of {
        ($method:ident) => {
            Function::Of { number: <f64 as Scalar>::$method, symbol: <Symbol as Scalar>::$method }
        };
    }
    Some(match name {
        "number" => Function::Step,
        "sqr" => of!(sqr),
        "recip" => of!(recip),
        "sqrt" => of!(sqrt),
        "exp" => of!(exp),
        "ln" => of!(ln),
        "sin" => of!(sin),
        "cos" => of!(cos),
        "tan" => of!(tan),
        "atan" => of!(atan),
        "sinh" => of!(sinh),
        "cosh" => of!(cosh),
        "tanh" => of!(tanh),
        _ => return None,
    })
}
