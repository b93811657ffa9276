//! The derivatives of an expression, as further steps of the tape on which it stands.

use tautline_scalar::Scalar;

use super::value::Value;
use crate::{
    operation::{Arithmetic, Function, Operation, Pair, Step},
    recording::{self, Symbol},
};

const ZERO: Value = Value::Number(0.0);

/// Returns the derivatives of an expression by each coordinate: forward, one step after the other. What does
/// not depend on a coordinate has the number 0 there.
pub(super) fn gradient(expression: Value, dimension: usize) -> Vec<Value> {
    let operations = &recording::operations()[..];
    let last = match expression {
        Value::Symbol(Symbol(last)) if (last as usize) < operations.len() => last as usize,
        // A number, or a step of a tape that has failed.
        _ => return vec![ZERO; dimension],
    };
    let mut needed = vec![false; last + 1];
    needed[last] = true;
    for place in (0..=last).rev() {
        if needed[place] {
            for read in operations[place].reads(place as Step).into_iter().flatten() {
                needed[read as usize] = true;
            }
        }
    }
    let mut gradients: Vec<Vec<Value>> = Vec::with_capacity(last + 1);
    for place in 0..=last {
        let of_one = |k: usize| {
            let by_k = |step: Step| gradients[step as usize][k];
            derivative(operations, place as Step, by_k, k)
        };
        let row = if needed[place] { (0..dimension).map(of_one).collect() } else { Vec::new() };
        gradients.push(row);
    }
    gradients.pop().unwrap_or_default()
}

/// The derivative of one step by a coordinate, from those of the steps that it reads.
fn derivative(
    operations: &[Operation],
    step: Step,
    by: impl Fn(Step) -> Value,
    coordinate: usize,
) -> Value {
    let at = |step: Step| Value::Symbol(Symbol(step));
    match operations[step as usize] {
        Operation::Coordinate(i) => Value::Number(f64::from(u8::from(i as usize == coordinate))),
        Operation::Constant(_) | Operation::Powi(_, 0) => ZERO,
        Operation::Binary(Arithmetic::Add, a, b) => sum(by(a), by(b)),
        Operation::Binary(Arithmetic::Sub, a, b) => difference(by(a), by(b)),
        Operation::Binary(Arithmetic::Mul, a, b) => sum(times(by(a), at(b)), times(at(a), by(b))),
        Operation::Binary(Arithmetic::Div, a, b) => {
            over(difference(by(a), times(at(step), by(b))), at(b))
        }
        Operation::WithNumber(Arithmetic::Add | Arithmetic::Sub, a, _) => by(a),
        Operation::WithNumber(Arithmetic::Mul, a, c) => times(by(a), Value::Number(c.value())),
        Operation::WithNumber(Arithmetic::Div, a, c) => over(by(a), Value::Number(c.value())),
        Operation::Powi(a, n) => {
            let outer = times(Value::Number(f64::from(n)), at(a).powi(n.wrapping_sub(1)));
            times(by(a), outer)
        }
        Operation::Of(function, a) => times(by(a), outer_derivative(function, at(a), at(step))),
        Operation::First(_, a) => times(by(a), at(step + 1)),
        Operation::Second => match operations[step as usize - 1] {
            Operation::First(Pair::SinCos, a) => times(by(a), -at(step - 1)),
            Operation::First(_, a) => times(by(a), at(step - 1)),
            // A second one follows its first one.
            _ => Value::Number(f64::NAN),
        },
    }
}

/// The derivative of a function by its argument `a`, where its value is `y`.
fn outer_derivative(function: Function, a: Value, y: Value) -> Value {
    let one = Value::Number(1.0);
    let of = |function: fn(Symbol) -> Symbol, a: Value| Value::Symbol(function(a.symbol()));
    match function {
        Function::Neg => -one,
        Function::Sqr => Value::Number(2.0) * a,
        Function::Recip => -y.squared(),
        Function::Sqrt => Value::Number(0.5) / y,
        Function::Exp => y,
        Function::Ln => one / a,
        Function::Sin => of(Scalar::cos, a),
        Function::Cos => -of(Scalar::sin, a),
        Function::Tan => y.squared() + one,
        Function::Atan => one / (a.squared() + one),
        Function::Sinh => of(Scalar::cosh, a),
        Function::Cosh => of(Scalar::sinh, a),
        Function::Tanh => one - y.squared(),
    }
}

// Without the steps that a structural 0 or 1 makes idle.

pub(super) fn sum(a: Value, b: Value) -> Value {
    if a.is(0.0) {
        b
    } else if b.is(0.0) {
        a
    } else {
        a + b
    }
}

fn difference(a: Value, b: Value) -> Value {
    if b.is(0.0) {
        a
    } else if a.is(0.0) {
        -b
    } else {
        a - b
    }
}

pub(super) fn times(a: Value, b: Value) -> Value {
    if a.is(0.0) || b.is(0.0) {
        ZERO
    } else if a.is(1.0) {
        b
    } else if b.is(1.0) {
        a
    } else {
        a * b
    }
}

fn over(a: Value, b: Value) -> Value {
    if a.is(0.0) { ZERO } else { a / b }
}
