//! `Operation`: one step of a recorded formula.

use tautline_scalar::Scalar;

/// The place of a step on its tape. A step reads earlier ones only.
pub type Step = u32;

/// A number by its bits, so that it can be compared and hashed: there is one NaN, and `−0` is not `0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Number(u64);

impl Number {
    /// Returns the number of this value.
    #[must_use]
    pub fn of(value: f64) -> Self {
        Self(if value.is_nan() { f64::NAN } else { value }.to_bits())
    }

    /// Returns its value.
    #[must_use]
    pub fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// The four operations of arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// `a + b`.
    Add,
    /// `a − b`.
    Sub,
    /// `a b`.
    Mul,
    /// `a / b`.
    Div,
}

/// A function of one number, as [`Scalar`](tautline_scalar::Scalar) has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// `−x`.
    Neg,
    /// `x²`.
    Sqr,
    /// `1 / x`.
    Recip,
    /// `√x`.
    Sqrt,
    /// `eˣ`.
    Exp,
    /// The natural logarithm.
    Ln,
    /// `sin x`, by itself.
    Sin,
    /// `cos x`, by itself.
    Cos,
    /// `tan x`.
    Tan,
    /// `arctan x`.
    Atan,
    /// `sinh x`, by itself.
    Sinh,
    /// `cosh x`, by itself.
    Cosh,
    /// `tanh x`.
    Tanh,
}

impl Function {
    /// Returns the value.
    #[must_use]
    pub fn of<S: Scalar>(self, x: S) -> S {
        match self {
            Function::Neg => -x,
            Function::Sqr => x.sqr(),
            Function::Recip => x.recip(),
            Function::Sqrt => x.sqrt(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Atan => x.atan(),
            Function::Sinh => x.sinh(),
            Function::Cosh => x.cosh(),
            Function::Tanh => x.tanh(),
        }
    }
}

/// Two functions of one number that are evaluated together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pair {
    /// `(sin x, cos x)`.
    SinCos,
    /// `(sinh x, cosh x)`.
    SinhCosh,
}

/// One step: what a formula asked of a number, as it asked for it.
///
/// `x + 2.0` and `x + S::constant(2.0)` are two different steps, and so are `a + b` and `b + a`: a number
/// type may evaluate them differently, to the last bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// The coordinate `xᵢ`, from 0 on.
    Coordinate(u32),
    /// A number.
    Constant(Number),
    /// `a ∘ b`.
    Binary(Arithmetic, Step, Step),
    /// `a ∘ c` with a number `c`.
    WithNumber(Arithmetic, Step, Number),
    /// `xⁿ`.
    Powi(Step, i32),
    /// `f(x)`.
    Of(Function, Step),
    /// The first of two functions of `x`; the other one is the next step.
    First(Pair, Step),
    /// The second of the two functions of the step before.
    Second,
}

impl Operation {
    /// Returns the steps that are read, of which there are two at most; for the second of a pair, which
    /// is at `place`, the first.
    pub(crate) fn reads(self, place: Step) -> [Option<Step>; 2] {
        match self {
            Operation::Coordinate(_) | Operation::Constant(_) => [None, None],
            Operation::Binary(_, a, b) => [Some(a), Some(b)],
            Operation::WithNumber(_, a, _)
            | Operation::Powi(a, _)
            | Operation::Of(_, a)
            | Operation::First(_, a) => [Some(a), None],
            Operation::Second => [place.checked_sub(1), None],
        }
    }

    /// Returns the same operation on other steps.
    pub(crate) fn with_reads(self, other: impl Fn(Step) -> Step) -> Self {
        match self {
            Operation::Coordinate(_) | Operation::Constant(_) | Operation::Second => self,
            Operation::Binary(how, a, b) => Operation::Binary(how, other(a), other(b)),
            Operation::WithNumber(how, a, c) => Operation::WithNumber(how, other(a), c),
            Operation::Powi(a, n) => Operation::Powi(other(a), n),
            Operation::Of(function, a) => Operation::Of(function, other(a)),
            Operation::First(pair, a) => Operation::First(pair, other(a)),
        }
    }
}
