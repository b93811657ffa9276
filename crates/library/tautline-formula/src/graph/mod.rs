//! `Graph`: expressions with shared subexpressions, simplified as they are built.

mod contraction;
mod derivative;
mod derivatives;
mod linear;
mod neck;
mod recorded;
mod slopes;
mod squares;

use std::{collections::HashMap, sync::Arc};

use tautline_scalar::Table;

pub(crate) use contraction::{Contracted, Sums, contract};
pub(crate) use derivative::Order;

use crate::operation::{Arithmetic, Function, Number, Operation, Step, Tabulation};

/// Which identities are used to simplify expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Identities {
    /// Identities that hold in doubles, except for the sign of a zero: `1 x = x` and `x x = x²`,
    /// but not `0 x = 0`.
    Exact,
    /// Identities that hold in real numbers. They are used for derivatives, where most terms
    /// vanish.
    Free,
}

/// A list of distinct operations, as in a [`Formula`](crate::Formula).
///
/// It has no pairs, no differences with a number, and no powers except squares. The coordinates are
/// those of the point, followed by those of the chord.
#[derive(Debug)]
pub(crate) struct Graph {
    /// The tables of the formula.
    tables: Vec<Arc<dyn Table>>,
    operations: Vec<Operation>,
    known: HashMap<Operation, Step>,
    identities: Identities,
    /// The largest number of operations.
    most: usize,
    /// Whether an operation did not fit. If so, the steps made since are meaningless.
    is_full: bool,
}

impl Graph {
    pub(crate) fn operations(&self) -> &[Operation] {
        &self.operations
    }

    pub(crate) fn operation(&self, step: Step) -> Operation {
        self.operations[step as usize]
    }

    pub(crate) fn tables(&self) -> &[Arc<dyn Table>] {
        &self.tables
    }

    /// Returns a table at some arguments.
    pub(crate) fn table(&mut self, call: Tabulation) -> Step {
        self.node(Operation::Table(call))
    }

    fn node(&mut self, operation: Operation) -> Step {
        let Self { operations, known, is_full, most, .. } = self;
        if let Some(&step) = known.get(&operation) {
            return step;
        }
        if operations.len() >= *most {
            *is_full = true;
            return 0;
        }
        let step = operations.len() as Step;
        operations.push(operation);
        known.insert(operation, step);
        step
    }

    /// Returns whether an operation did not fit.
    pub(crate) fn is_full(&self) -> bool {
        self.is_full
    }

    fn is_free(&self) -> bool {
        self.identities == Identities::Free
    }

    /// Returns the value of a constant step.
    pub(crate) fn value(&self, a: Step) -> Option<f64> {
        match self.operation(a) {
            Operation::Constant(number) => Some(number.value()),
            _ => None,
        }
    }

    pub(crate) fn is_zero(&self, a: Step) -> bool {
        self.value(a) == Some(0.0)
    }

    pub(crate) fn constant(&mut self, value: f64) -> Step {
        self.node(Operation::Constant(Number::of(value)))
    }

    /// Returns the coordinate `xᵢ`, or `dᵢ₋D` if `i` is at least `D`.
    pub(crate) fn coordinate(&mut self, i: usize) -> Step {
        self.node(Operation::Coordinate(i as u32))
    }

    /// Returns `(x, c)` with `a = c x`, where `x` is not itself a multiple unless `c` would not be
    /// normal.
    fn scaled(&self, a: Step) -> (Step, f64) {
        // This is a loop, since a formula may chain any number of multiplications.
        let (mut x, mut factor) = (a, 1.0);
        loop {
            let (inner, c) = match self.operation(x) {
                Operation::WithNumber(Arithmetic::Mul, inner, c) => (inner, c.value()),
                Operation::Of(Function::Neg, inner) => (inner, -1.0),
                _ => return (x, factor),
            };
            if !(factor * c).is_normal() {
                return (x, factor);
            }
            (x, factor) = (inner, factor * c);
        }
    }

    fn negated(&self, a: Step) -> Option<Step> {
        match self.operation(a) {
            Operation::Of(Function::Neg, x) => Some(x),
            _ => None,
        }
    }

    /// Returns `a + b`.
    pub(crate) fn add(&mut self, a: Step, b: Step) -> Step {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => return self.constant(x + y),
            (Some(x), None) => return self.plus(b, x),
            (None, Some(y)) => return self.plus(a, y),
            (None, None) => {}
        }
        if self.is_free() {
            let ((x, c), (y, d)) = (self.scaled(a), self.scaled(b));
            if x == y {
                return self.times(x, c + d);
            }
            if c == d && c.abs() != 1.0 {
                let sum = self.add(x, y);
                return self.times(sum, c);
            }
            if c == -d && c.abs() != 1.0 {
                let difference = self.sub(x, y);
                return self.times(difference, c);
            }
        }
        match (self.negated(a), self.negated(b)) {
            (_, Some(y)) => self.node(Operation::Binary(Arithmetic::Sub, a, y)),
            (Some(x), None) => self.node(Operation::Binary(Arithmetic::Sub, b, x)),
            (None, None) => self.node(Operation::Binary(Arithmetic::Add, a.min(b), a.max(b))),
        }
    }

    /// Returns `a − b`.
    pub(crate) fn sub(&mut self, a: Step, b: Step) -> Step {
        if self.is_free() && a == b {
            return self.constant(0.0);
        }
        if self.is_free() || self.value(a).is_some() || self.value(b).is_some() {
            let minus = self.neg(b);
            return self.add(a, minus);
        }
        match self.negated(b) {
            Some(y) => self.add(a, y),
            None => self.node(Operation::Binary(Arithmetic::Sub, a, b)),
        }
    }

    /// Returns `−a`.
    pub(crate) fn neg(&mut self, a: Step) -> Step {
        match self.operation(a) {
            Operation::Constant(c) => self.constant(-c.value()),
            Operation::Of(Function::Neg, x) => x,
            Operation::Binary(Arithmetic::Sub, x, y) => {
                self.node(Operation::Binary(Arithmetic::Sub, y, x))
            }
            Operation::WithNumber(Arithmetic::Mul, x, c) => self.multiple(x, -c.value()),
            _ => self.node(Operation::Of(Function::Neg, a)),
        }
    }

    /// Returns `a + c`.
    pub(crate) fn plus(&mut self, a: Step, c: f64) -> Step {
        match self.value(a) {
            Some(x) => self.constant(x + c),
            None if c == 0.0 => a,
            None => self.node(Operation::WithNumber(Arithmetic::Add, a, Number::of(c))),
        }
    }

    /// Returns `a c`.
    pub(crate) fn times(&mut self, a: Step, c: f64) -> Step {
        if let Some(x) = self.value(a) {
            return self.constant(x * c);
        }
        if self.is_free() {
            if c == 0.0 {
                return self.constant(0.0);
            }
            // A product that overflows or underflows would lose what the two factors keep.
            let (x, d) = self.scaled(a);
            if x != a && (c * d).is_normal() {
                return self.multiple(x, c * d);
            }
        }
        self.multiple(a, c)
    }

    /// Returns `a c`, without merging factors.
    fn multiple(&mut self, a: Step, c: f64) -> Step {
        if c == 1.0 {
            a
        } else if c == -1.0 {
            self.neg(a)
        } else if let Some(x) = self.negated(a) {
            self.node(Operation::WithNumber(Arithmetic::Mul, x, Number::of(-c)))
        } else {
            self.node(Operation::WithNumber(Arithmetic::Mul, a, Number::of(c)))
        }
    }

    /// Returns `a b`.
    pub(crate) fn mul(&mut self, a: Step, b: Step) -> Step {
        if let Some(x) = self.value(a) {
            return self.times(b, x);
        }
        if let Some(y) = self.value(b) {
            return self.times(a, y);
        }
        if self.is_free() {
            let ((x, c), (y, d)) = (self.scaled(a), self.scaled(b));
            if (c, d) != (1.0, 1.0) && (c * d).is_normal() {
                let product = self.product(x, y);
                return self.multiple(product, c * d);
            }
        }
        self.product(a, b)
    }

    /// Returns `a b`, without extracting factors.
    fn product(&mut self, a: Step, b: Step) -> Step {
        if a == b {
            self.node(Operation::Of(Function::Sqr, a))
        } else {
            self.node(Operation::Binary(Arithmetic::Mul, a.min(b), a.max(b)))
        }
    }

    /// Returns `a / b`.
    pub(crate) fn div(&mut self, a: Step, b: Step) -> Step {
        match (self.value(a), self.value(b)) {
            (_, Some(y)) => self.over(a, y),
            (Some(1.0), None) => self.apply(Function::Recip, b),
            (Some(0.0), None) if self.is_free() => a,
            _ => self.node(Operation::Binary(Arithmetic::Div, a, b)),
        }
    }

    /// Returns `a / c`.
    pub(crate) fn over(&mut self, a: Step, c: f64) -> Step {
        if let Some(x) = self.value(a) {
            self.constant(x / c)
        } else if self.is_free() && c.recip().is_normal() {
            self.times(a, c.recip())
        } else {
            self.node(Operation::WithNumber(Arithmetic::Div, a, Number::of(c)))
        }
    }

    /// Returns `aⁿ`, computed by squaring.
    pub(crate) fn power(&mut self, a: Step, n: i32) -> Step {
        let (mut power, mut square, mut left) = (None, a, n.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                power = Some(power.map_or(square, |power| self.mul(power, square)));
            }
            left >>= 1;
            if left > 0 {
                square = self.mul(square, square);
            }
        }
        match power {
            None => self.constant(1.0),
            Some(power) if n < 0 => self.apply(Function::Recip, power),
            Some(power) => power,
        }
    }

    /// Returns `f(a)`.
    pub(crate) fn apply(&mut self, function: Function, a: Step) -> Step {
        match (function, self.value(a)) {
            (Function::Neg, _) => self.neg(a),
            (Function::Sqr, _) => self.mul(a, a),
            (_, Some(x)) => self.constant(function.of(x)),
            (_, None) => self.node(Operation::Of(function, a)),
        }
    }

    /// Returns the sum of the terms.
    pub(crate) fn sum(&mut self, terms: impl IntoIterator<Item = Step>) -> Step {
        terms
            .into_iter()
            .reduce(|sum, term| self.add(sum, term))
            .unwrap_or_else(|| self.constant(0.0))
    }

    /// From now on, all identities of real numbers apply.
    pub(crate) fn be_free(&mut self) {
        self.identities = Identities::Free;
    }
}
