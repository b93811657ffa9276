//! `Recording`, a tape under construction, and `Symbol`, the number type that writes to it.

use std::{
    cell::RefCell,
    collections::HashMap,
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::Arc,
};

use num_traits::{One, Zero};
use tautline_scalar::{Scalar, Table};

use crate::{
    LONGEST, RecordError,
    operation::{Arithmetic, Function, Number, Operation, Pair, Step, Tabulation},
};

/// A tape under construction. Identical steps are written only once. Nothing else is simplified.
#[derive(Debug, Default)]
pub(crate) struct Recording {
    pub(crate) operations: Vec<Operation>,
    /// The tables, each once.
    pub(crate) tables: Vec<Arc<dyn Table>>,
    known: HashMap<Operation, Step>,
    /// The first reason why the tape does not represent the formula, if there is one.
    pub(crate) failed: Option<RecordError>,
}

impl Recording {
    /// Returns a tape that holds only the coordinates.
    pub(crate) fn new(dimension: usize) -> Self {
        let mut recording = Self::default();
        for i in 0..dimension {
            recording.write(Operation::Coordinate(i as u32));
        }
        recording
    }

    fn fail(&mut self, error: RecordError) {
        self.failed.get_or_insert(error);
    }

    /// Returns the step of an operation, and writes it if it is new.
    fn write(&mut self, operation: Operation) -> Step {
        let end = self.operations.len();
        // This is a number kept from another recording.
        if operation.reads(0).into_iter().flatten().any(|step| step as usize >= end) {
            self.fail(RecordError::Foreign);
            return 0;
        }
        if let Some(&step) = self.known.get(&operation) {
            return step;
        }
        // There must be room for two steps, since a pair stays together.
        if end + 2 > LONGEST {
            self.fail(RecordError::TooLong { most: LONGEST });
            return 0;
        }
        let step = end as Step;
        self.operations.push(operation);
        self.known.insert(operation, step);
        if matches!(operation, Operation::First(..)) {
            self.operations.push(Operation::Second);
        }
        step
    }

    /// Writes a table at some arguments.
    fn tabulate(&mut self, table: &Arc<dyn Table>, orders: [u8; 3], u: &[Symbol]) -> Step {
        if u.len() != table.axes() || !(1..=3).contains(&u.len()) {
            return self.write(Operation::Constant(Number::of(f64::NAN)));
        }
        let known = self.tables.iter().position(|known| known == table);
        let number = known.unwrap_or_else(|| {
            self.tables.push(Arc::clone(table));
            self.tables.len() - 1
        });
        let argument = |axis: usize| u.get(axis).unwrap_or(&u[0]).0;
        self.write(Operation::Table(Tabulation {
            table: number as u32,
            orders,
            axes: u.len() as u8,
            arguments: [argument(0), argument(1), argument(2)],
        }))
    }

    fn constant(&self, symbol: Symbol) -> Option<f64> {
        match self.operations.get(symbol.0 as usize) {
            Some(Operation::Constant(number)) => Some(number.value()),
            _ => None,
        }
    }
}

thread_local! {
    /// The recording of this thread.
    static RECORDING: RefCell<Option<Recording>> = const { RefCell::new(None) };
}

/// Restores the outer recording when dropped, even if the formula panics.
struct Outer(Option<Recording>);

impl Drop for Outer {
    fn drop(&mut self) {
        RECORDING.set(self.0.take());
    }
}

/// Returns the result of `formula` at symbolic coordinates, and the tape.
pub(crate) fn record<T>(dimension: usize, formula: impl FnOnce(&[Symbol]) -> T) -> (T, Recording) {
    let (outer, coordinates) = begin(dimension);
    let result = formula(&coordinates);
    (result, end(outer))
}

fn begin(dimension: usize) -> (Outer, Vec<Symbol>) {
    let outer = Outer(RECORDING.replace(Some(Recording::new(dimension))));
    (outer, (0..dimension).map(|i| Symbol(i as Step)).collect())
}

fn end(outer: Outer) -> Recording {
    let recording = RECORDING.take().unwrap_or_default();
    drop(outer);
    recording
}

/// Marks the recording of this thread as failed, because its tape does not represent the formula.
pub(crate) fn fail(error: RecordError) {
    with((), |recording| recording.fail(error));
}

/// Returns the steps of this thread's recording so far.
pub(crate) fn operations() -> Vec<Operation> {
    with(Vec::new(), |recording| recording.operations.clone())
}

/// Returns whether the recording of this thread has failed.
pub(crate) fn has_failed() -> bool {
    with(false, |recording| recording.failed.is_some())
}

/// A number that records its operations: the index of a step on the tape of this thread.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Symbol(pub(crate) Step);

/// A step that is on no tape.
const NOWHERE: Step = Step::MAX;

/// Writes to the tape of this thread. If there is no tape, for example on a thread that the formula
/// started, returns `otherwise`.
fn with<T>(otherwise: T, write: impl FnOnce(&mut Recording) -> T) -> T {
    RECORDING.with_borrow_mut(|recording| recording.as_mut().map(write).unwrap_or(otherwise))
}

impl Symbol {
    fn write(operation: Operation) -> Self {
        Self(with(NOWHERE, |recording| recording.write(operation)))
    }

    /// Writes a table of this recording at some of its steps.
    pub(crate) fn of_table(call: Tabulation) -> Self {
        Self::write(Operation::Table(call))
    }

    fn of(self, function: Function) -> Self {
        Self::write(Operation::Of(function, self.0))
    }

    fn both(self, pair: Pair) -> (Self, Self) {
        let first = Self::write(Operation::First(pair, self.0)).0;
        (Self(first), Self(first.saturating_add(1)))
    }
}

impl PartialEq for Symbol {
    /// Two constants can be compared. Any other answer would hold at one point only, and the tape
    /// would follow only one branch.
    fn eq(&self, other: &Self) -> bool {
        with(false, |recording| match (recording.constant(*self), recording.constant(*other)) {
            (Some(a), Some(b)) => a == b,
            _ => {
                recording.fail(RecordError::Compares);
                false
            }
        })
    }
}

macro_rules! arithmetic {
    ($($operator:ident $method:ident, $assign:ident $assign_method:ident;)*) => {$(
        impl $operator for Symbol {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::write(Operation::Binary(Arithmetic::$operator, self.0, other.0))
            }
        }
        impl $operator<f64> for Symbol {
            type Output = Self;
            fn $method(self, c: f64) -> Self {
                Self::write(Operation::WithNumber(Arithmetic::$operator, self.0, Number::of(c)))
            }
        }
        impl $assign for Symbol {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

arithmetic! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
    Div div, DivAssign div_assign;
}

tautline_scalar::f64_on_the_left!([] Symbol);

impl Neg for Symbol {
    type Output = Self;
    fn neg(self) -> Self {
        self.of(Function::Neg)
    }
}

impl Zero for Symbol {
    fn zero() -> Self {
        Self::constant(0.0)
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Symbol {
    fn one() -> Self {
        Self::constant(1.0)
    }
}

macro_rules! functions {
    ($($method:ident $function:ident)*) => {$(
        fn $method(self) -> Self {
            self.of(Function::$function)
        }
    )*};
}

impl Scalar for Symbol {
    fn constant(value: f64) -> Self {
        Self::write(Operation::Constant(Number::of(value)))
    }

    fn tabulated(table: &Arc<dyn Table>, orders: [u8; 3], u: &[Self]) -> Self {
        if let Some((base, factor)) = table.base() {
            let scaled: Vec<Self> = u.iter().map(|&u| u * factor).collect();
            let order = orders.iter().map(|&order| i32::from(order)).sum();
            let value = Self::tabulated(&base, orders, &scaled);
            return if order == 0 { value } else { value * factor.powi(order) };
        }
        Self(with(NOWHERE, |recording| recording.tabulate(table, orders, u)))
    }

    fn powi(self, n: i32) -> Self {
        Self::write(Operation::Powi(self.0, n))
    }

    fn sin_cos(self) -> (Self, Self) {
        self.both(Pair::SinCos)
    }

    fn sinh_cosh(self) -> (Self, Self) {
        self.both(Pair::SinhCosh)
    }

    functions! {
        sqr Sqr recip Recip sqrt Sqrt exp Exp ln Ln
        sin Sin cos Cos tan Tan atan Atan sinh Sinh cosh Cosh tanh Tanh
    }
}
