//! The derivatives of functions, as further steps of the tape on which they stand.

use tautline_scalar::Scalar;

use super::value::Value;
use crate::{
    operation::{Arithmetic, Function, Operation, Pair, Step},
    recording::{self, Symbol},
};

const ZERO: Value = Value::Number(0.0);
const UNDEFINED: Value = Value::Number(f64::NAN);

/// Returns the derivatives of each function by each coordinate: forward, one step after the other. What does
/// not depend on a coordinate has the number 0 there; where a function is undefined, so are they.
pub(super) fn gradients(functions: &[Value], dimension: usize) -> Vec<Vec<Value>> {
    let operations = &recording::operations()[..];
    let mut needed = vec![false; operations.len()];
    for function in functions {
        if let Value::Symbol(Symbol(step)) = function
            && let Some(needed) = needed.get_mut(*step as usize)
        {
            *needed = true;
        }
    }
    for place in (0..operations.len()).rev().filter(|&place| place >= dimension) {
        if needed[place] {
            for read in operations[place].reads(place as Step).into_iter().flatten() {
                needed[read as usize] = true;
            }
        }
    }
    // Coordinate by coordinate, so that memory does not grow with their number.
    let columns: Vec<Vec<Value>> = (0..dimension)
        .map(|coordinate| {
            let mut made = vec![ZERO; operations.len()];
            for place in 0..operations.len() {
                // A tape that is too long stands for nothing, however it goes on.
                if needed[place] && !recording::has_failed() {
                    made[place] = derivative(operations, place as Step, &made, coordinate);
                }
            }
            let of = |function: &Value| match function {
                Value::Symbol(Symbol(step)) => made.get(*step as usize).copied().unwrap_or(ZERO),
                Value::Number(value) if value.is_finite() => ZERO,
                Value::Number(_) => UNDEFINED,
            };
            functions.iter().map(of).collect()
        })
        .collect();
    (0..functions.len()).map(|k| columns.iter().map(|column| column[k]).collect()).collect()
}

/// The derivative of one step by a coordinate, from those `made` of the steps before it.
fn derivative(operations: &[Operation], step: Step, made: &[Value], coordinate: usize) -> Value {
    let at = |step: Step| Value::Symbol(Symbol(step));
    let by = |step: Step| made[step as usize];
    match operations[step as usize] {
        Operation::Coordinate(i) => Value::Number(f64::from(u8::from(i as usize == coordinate))),
        Operation::Constant(c) if c.value().is_finite() => ZERO,
        Operation::Constant(_) => UNDEFINED,
        Operation::Binary(Arithmetic::Add, a, b) => sum(by(a), by(b)),
        Operation::Binary(Arithmetic::Sub, a, b) => difference(by(a), by(b)),
        Operation::Binary(Arithmetic::Mul, a, b) => sum(along(by(a), at(b)), along(by(b), at(a))),
        Operation::Binary(Arithmetic::Div, a, b) => {
            let changed = difference(by(a), along(by(b), at(step)));
            if changed.is(0.0) { ZERO } else { changed / at(b) }
        }
        Operation::WithNumber(Arithmetic::Add | Arithmetic::Sub, a, c) if c.value().is_finite() => {
            by(a)
        }
        Operation::WithNumber(Arithmetic::Add | Arithmetic::Sub, ..) => UNDEFINED,
        Operation::WithNumber(Arithmetic::Mul, a, c) => along(by(a), Value::Number(c.value())),
        Operation::WithNumber(Arithmetic::Div, a, _) if by(a).is(0.0) => ZERO,
        Operation::WithNumber(Arithmetic::Div, a, c) => by(a) / Value::Number(c.value()),
        _ if reads_none_that_change(operations, step, made) => ZERO,
        // The power 0 is 1, but not where its base is undefined.
        Operation::Powi(a, 0) => along(by(a), at(a) * ZERO),
        // The exponent less 1 is no whole number of 32 bits.
        Operation::Powi(a, i32::MIN) => {
            along(by(a), Value::Number(f64::from(i32::MIN)) * at(step) / at(a))
        }
        Operation::Powi(a, n) => along(by(a), Value::Number(f64::from(n)) * at(a).powi(n - 1)),
        Operation::Of(function, a) => along(by(a), outer_derivative(function, at(a), at(step))),
        Operation::First(_, a) => along(by(a), at(step + 1)),
        Operation::Second => match operations[step as usize - 1] {
            Operation::First(Pair::SinCos, a) => along(by(a), -at(step - 1)),
            Operation::First(_, a) => along(by(a), at(step - 1)),
            // A second one follows its first one.
            _ => UNDEFINED,
        },
    }
}

/// Whether the one step that is read has the derivative 0: then no derivative of the function is written.
fn reads_none_that_change(operations: &[Operation], step: Step, made: &[Value]) -> bool {
    let step = match operations[step as usize] {
        Operation::Second => step - 1,
        _ => step,
    };
    let reads = operations[step as usize].reads(step).into_iter().flatten();
    reads.into_iter().all(|read| made[read as usize].is(0.0))
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
        // Below 0 there is no logarithm, but there is 1/a.
        Function::Ln => one / a + y * ZERO,
        Function::Sin => of(Scalar::cos, a),
        Function::Cos => -of(Scalar::sin, a),
        Function::Tan => y.squared() + one,
        Function::Atan => one / (a.squared() + one),
        Function::Sinh => of(Scalar::cosh, a),
        Function::Cosh => of(Scalar::sinh, a),
        Function::Tanh => one - y.squared(),
    }
}

// Without the steps that a derivative 0 or 1 makes idle.

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

/// The derivative `by` of what a function is of, times that of the function.
pub(super) fn along(by: Value, outer: Value) -> Value {
    if by.is(0.0) {
        ZERO
    } else if by.is(1.0) {
        outer
    } else {
        by * outer
    }
}
