//! Derivatives of functions, appended to their tape.

use tautline_scalar::{Interval, Scalar};

use super::value::Value;
use crate::{
    operation::{Arithmetic, Function, Operation, Pair, Step, needed},
    recording::{self, Symbol},
};

const ZERO: Value = Value::Number(0.0);
const UNDEFINED: Value = Value::Number(f64::NAN);

/// Returns the derivatives of each function with respect to each of these coordinates, by forward
/// differentiation. A derivative that vanishes is the number 0; one that only rounds to 0 is a step.
/// Where a function is undefined, so are its derivatives.
pub(super) fn gradients(functions: &[Value], coordinates: &[usize]) -> Vec<Vec<Value>> {
    let operations = &recording::operations()[..];
    let roots: Vec<Step> = functions
        .iter()
        .filter_map(|function| match function {
            Value::Symbol(Symbol(step)) => Some(*step),
            Value::Number(_) => None,
        })
        .filter(|&step| (step as usize) < operations.len())
        .collect();
    let needed = needed(operations, &roots, |_| true);
    // The steps that may be undefined, while no derivative so far would tell.
    let known = constants(operations);
    let is_partial = operations.iter().zip(&needed).zip(&known).map(|((step, needed), known)| {
        *needed && may_fail(step) && known.is_none_or(Interval::is_undefined)
    });
    let mut silent: Vec<bool> = is_partial.collect();
    let column = |coordinate: usize, silent: &mut [bool], speak: bool| -> Vec<Value> {
        let mut made = vec![ZERO; operations.len()];
        for place in 0..needed.len() {
            // A tape that is too long is refused anyway.
            if needed[place] && !recording::has_failed() {
                made[place] = derivative(operations, place as Step, &made, coordinate);
                silent[place] &= made[place].is(0.0);
                if silent[place] && speak {
                    made[place] = Value::Symbol(Symbol(place as Step)) * ZERO;
                }
            }
        }
        let of = |function: &Value| match function {
            Value::Symbol(Symbol(step)) => made.get(*step as usize).copied().unwrap_or(ZERO),
            other if other.number().is_some_and(f64::is_finite) => ZERO,
            _ => UNDEFINED,
        };
        functions.iter().map(of).collect()
    };
    // The loop runs over the coordinates, so that memory does not grow with the dimension.
    let mut columns: Vec<Vec<Value>> =
        coordinates.iter().map(|&coordinate| column(coordinate, &mut silent, false)).collect();
    // A logarithm of `0·x₁ − 1` does not change, and is undefined.
    if let ([first, ..], true) = (coordinates, silent.contains(&true)) {
        columns[0] = column(*first, &mut silent, true);
    }
    (0..functions.len()).map(|k| columns.iter().map(|column| column[k]).collect()).collect()
}

/// Returns bounds on the steps that read no coordinate.
fn constants(operations: &[Operation]) -> Vec<Option<Interval>> {
    let mut known: Vec<Option<Interval>> = Vec::with_capacity(operations.len());
    for operation in operations {
        let at = |step: Step| known.get(step as usize).copied().flatten();
        let value = match *operation {
            Operation::Constant(c) => Some(Interval::point(c.value())),
            Operation::Binary(how, a, b) => at(a).zip(at(b)).map(|(a, b)| how.of(a, b)),
            Operation::WithNumber(how, a, c) => {
                at(a).map(|a| how.of(a, Interval::point(c.value())))
            }
            Operation::Powi(a, n) => at(a).map(|a| a.powi(n)),
            Operation::Of(function, a) => at(a).map(|a| function.of(a)),
            _ => None,
        };
        known.push(value);
    }
    known
}

/// Returns whether a step may be undefined although those that it reads are defined.
fn may_fail(operation: &Operation) -> bool {
    match *operation {
        Operation::Binary(Arithmetic::Div, ..) => true,
        Operation::WithNumber(Arithmetic::Mul, _, c) => !c.value().is_finite(),
        Operation::WithNumber(Arithmetic::Div, _, c) => !c.value().is_finite() || c.value() == 0.0,
        Operation::Powi(_, n) => n < 0,
        Operation::Of(function, _) => {
            matches!(function, Function::Recip | Function::Sqrt | Function::Ln | Function::Tan)
        }
        // A table may have an end.
        Operation::Table(_) => true,
        _ => false,
    }
}

/// Returns the derivative of a step with respect to a coordinate, given those `made` for earlier
/// steps.
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
        // x⁰ is 1 only where x is defined.
        Operation::Powi(a, 0) => along(by(a), at(a) * ZERO),
        // The exponent minus 1 would overflow.
        Operation::Powi(a, i32::MIN) => {
            along(by(a), Value::Number(f64::from(i32::MIN)) * at(step) / at(a))
        }
        Operation::Powi(a, n) => along(by(a), Value::Number(f64::from(n)) * power(at(a), n - 1)),
        Operation::Of(function, a) => along(by(a), outer_derivative(function, at(a), at(step))),
        Operation::First(_, a) => along(by(a), at(step + 1)),
        Operation::Second => match operations[step as usize - 1] {
            Operation::First(Pair::SinCos, a) => along(by(a), -at(step - 1)),
            Operation::First(_, a) => along(by(a), at(step - 1)),
            // A second step always follows its first.
            _ => UNDEFINED,
        },
        Operation::Table(call) => {
            let along_axis = |(axis, &argument): (usize, &Step)| {
                let slope = || Value::Symbol(Symbol::of_table(call.along(axis)));
                match () {
                    _ if by(argument).is(0.0) => ZERO,
                    // Third derivatives jump.
                    _ if call.orders[axis] >= 2 => UNDEFINED,
                    _ => along(by(argument), slope()),
                }
            };
            call.arguments().iter().enumerate().map(along_axis).fold(ZERO, sum)
        }
    }
}

fn power(a: Value, n: i32) -> Value {
    Value::Symbol(a.symbol().powi(n))
}

/// Returns whether the argument has derivative 0, so that the function needs no derivative.
fn reads_none_that_change(operations: &[Operation], step: Step, made: &[Value]) -> bool {
    let step = match operations[step as usize] {
        Operation::Second => step - 1,
        _ => step,
    };
    let reads = operations[step as usize].reads(step).into_iter().flatten();
    reads.into_iter().all(|read| made[read as usize].is(0.0))
}

/// Returns `f′(a)`, where `y = f(a)`.
fn outer_derivative(function: Function, a: Value, y: Value) -> Value {
    let one = Value::Number(1.0);
    let of = |function: fn(Symbol) -> Symbol, a: Value| Value::Symbol(function(a.symbol()));
    match function {
        Function::Neg => -one,
        Function::Sqr => Value::Number(2.0) * a,
        Function::Recip => -y.squared(),
        Function::Sqrt => Value::Number(0.5) / y,
        Function::Exp => y,
        // 1/a is defined for negative a, but the logarithm is not.
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

// Steps that a derivative 0 or 1 makes redundant are omitted.

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

/// Applies the chain rule: multiplies the derivative `by` of the argument by the `outer`
/// derivative.
pub(super) fn along(by: Value, outer: Value) -> Value {
    if by.is(0.0) {
        ZERO
    } else if by.is(1.0) {
        outer
    } else {
        by * outer
    }
}
