//! `Operation`: one step of a recorded formula.

use std::ops::{Add, Div, Mul, Sub};

use tautline_scalar::{Scalar, elementary};

/// The place of a step on its tape. A step reads only earlier steps.
pub type Step = u32;

/// A number, compared and hashed by its bits. There is only one NaN, and `−0` is not `0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Number(u64);

impl Number {
    /// Returns the number with this value.
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

impl Arithmetic {
    /// Returns `a ∘ b`.
    #[must_use]
    pub fn of<A, B>(self, a: A, b: B) -> A
    where
        A: Add<B, Output = A> + Sub<B, Output = A> + Mul<B, Output = A> + Div<B, Output = A>,
    {
        match self {
            Arithmetic::Add => a + b,
            Arithmetic::Sub => a - b,
            Arithmetic::Mul => a * b,
            Arithmetic::Div => a / b,
        }
    }

    /// Returns the operator's sign in a text.
    pub(crate) fn sign(self) -> char {
        match self {
            Arithmetic::Add => '+',
            Arithmetic::Sub => '-',
            Arithmetic::Mul => '*',
            Arithmetic::Div => '/',
        }
    }
}

/// Defines [`Function`]: for each function, the method of [`Scalar`] and its name in a text.
macro_rules! functions {
    ($($(#[$doc:meta])* $function:ident $method:ident $name:literal;)*) => {
        /// A function of one number that [`Scalar`] provides.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Function {
            $($(#[$doc])* $function,)*
        }

        impl Function {
            /// The names of all functions in a text; that of `−x` is its sign.
            pub const NAMES: &[&str] = &[$($name),*];

            /// Returns the value at `x`.
            #[must_use]
            pub fn of<S: Scalar>(self, x: S) -> S {
                match self {
                    $(Function::$function => x.$method(),)*
                }
            }

            /// Returns the function's name in a text.
            pub(crate) fn name(self) -> &'static str {
                match self {
                    $(Function::$function => $name,)*
                }
            }

            /// Returns the function with this name in a text.
            pub(crate) fn named(name: &str) -> Option<Self> {
                match name {
                    $($name => Some(Function::$function),)*
                    _ => None,
                }
            }
        }
    };
}

functions! {
    /// `−x`.
    Neg neg "-";
    /// `x²`.
    Sqr sqr "sqr";
    /// `1 / x`.
    Recip recip "recip";
    /// `√x`.
    Sqrt sqrt "sqrt";
    /// `eˣ`.
    Exp exp "exp";
    /// The natural logarithm.
    Ln ln "ln";
    /// `sin x` alone.
    Sin sin "sin";
    /// `cos x` alone.
    Cos cos "cos";
    /// `tan x`.
    Tan tan "tan";
    /// `arctan x`.
    Atan atan "atan";
    /// `sinh x` alone.
    Sinh sinh "sinh";
    /// `cosh x` alone.
    Cosh cosh "cosh";
    /// `tanh x`.
    Tanh tanh "tanh";
}

impl Function {
    /// Returns the value at `x`, and the first and the second derivative there.
    #[must_use]
    pub fn expanded<S: Scalar>(self, x: S) -> [S; 3] {
        match self {
            Function::Neg => [-x, -S::one(), S::zero()],
            Function::Sqr => elementary::sqr(x),
            Function::Recip => elementary::recip(x),
            Function::Sqrt => elementary::sqrt(x),
            Function::Exp => elementary::exp(x),
            Function::Ln => elementary::ln(x),
            Function::Sin => Pair::SinCos.expanded(x)[0],
            Function::Cos => Pair::SinCos.expanded(x)[1],
            Function::Tan => elementary::tan(x),
            Function::Atan => elementary::atan(x),
            Function::Sinh => Pair::SinhCosh.expanded(x)[0],
            Function::Cosh => Pair::SinhCosh.expanded(x)[1],
            Function::Tanh => elementary::tanh(x),
        }
    }
}

/// Two functions of one number, evaluated together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pair {
    /// `(sin x, cos x)`.
    SinCos,
    /// `(sinh x, cosh x)`.
    SinhCosh,
}

impl Pair {
    /// Returns the two functions.
    #[must_use]
    pub fn functions(self) -> [Function; 2] {
        match self {
            Pair::SinCos => [Function::Sin, Function::Cos],
            Pair::SinhCosh => [Function::Sinh, Function::Cosh],
        }
    }

    /// Returns the values at `x`, each with the first and the second derivative.
    #[must_use]
    pub fn expanded<S: Scalar>(self, x: S) -> [[S; 3]; 2] {
        match self {
            Pair::SinCos => elementary::sin_cos(x),
            Pair::SinhCosh => elementary::sinh_cosh(x),
        }
    }
}

/// A partial derivative of a table, and the steps at which it is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tabulation {
    /// The number of the table among those of the formula.
    pub table: u32,
    /// The orders along the axes.
    pub orders: [u8; 3],
    /// The number of arguments, 1 to 3.
    pub axes: u8,
    /// The arguments; those beyond the last axis repeat the first.
    pub arguments: [Step; 3],
}

impl Tabulation {
    /// Returns the derivative along an axis.
    pub(crate) fn along(mut self, axis: usize) -> Self {
        self.orders[axis] = self.orders[axis].saturating_add(1);
        self
    }

    /// Returns the arguments.
    #[must_use]
    pub fn arguments(&self) -> &[Step] {
        &self.arguments[..usize::from(self.axes)]
    }
}

/// One step: an operation exactly as the formula called it.
///
/// `x + 2.0` and `x + S::constant(2.0)` are different steps, and so are `a + b` and `b + a`, since
/// a number type may round them differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// The coordinate `xᵢ`; the index starts at 0.
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
    /// The first of two functions of `x`. The second one is the next step.
    First(Pair, Step),
    /// The second of the two functions of the previous step.
    Second,
    /// A table at some arguments.
    Table(Tabulation),
}

impl Operation {
    /// Returns the steps that the operation at `place` reads. The second of a pair reads the first.
    pub(crate) fn reads(self, place: Step) -> [Option<Step>; 3] {
        match self {
            Operation::Coordinate(_) | Operation::Constant(_) => [None; 3],
            Operation::Binary(_, a, b) => [Some(a), Some(b), None],
            Operation::WithNumber(_, a, _)
            | Operation::Powi(a, _)
            | Operation::Of(_, a)
            | Operation::First(_, a) => [Some(a), None, None],
            Operation::Second => [place.checked_sub(1), None, None],
            Operation::Table(call) => {
                let used = |axis: usize| call.arguments().get(axis).copied();
                [used(0), used(1), used(2)]
            }
        }
    }

    /// Returns the same operation on renamed steps.
    pub(crate) fn with_reads(self, other: impl Fn(Step) -> Step) -> Self {
        match self {
            Operation::Coordinate(_) | Operation::Constant(_) | Operation::Second => self,
            Operation::Binary(how, a, b) => Operation::Binary(how, other(a), other(b)),
            Operation::WithNumber(how, a, c) => Operation::WithNumber(how, other(a), c),
            Operation::Powi(a, n) => Operation::Powi(other(a), n),
            Operation::Of(function, a) => Operation::Of(function, other(a)),
            Operation::First(pair, a) => Operation::First(pair, other(a)),
            Operation::Table(call) => {
                Operation::Table(Tabulation { arguments: call.arguments.map(other), ..call })
            }
        }
    }
}

/// Returns the function of one number that the step at `place` computes, with its argument. One
/// half of a pair counts as a function. Returns `None` for all other operations.
pub(crate) fn function_at(operations: &[Operation], place: usize) -> Option<(Function, Step)> {
    match *operations.get(place)? {
        Operation::Of(function, a) => Some((function, a)),
        Operation::First(pair, a) => Some((pair.functions()[0], a)),
        Operation::Second => match operations[place.checked_sub(1)?] {
            Operation::First(pair, a) => Some((pair.functions()[1], a)),
            _ => None,
        },
        _ => None,
    }
}

/// Returns which steps, up to the last root, the roots depend on, including the roots themselves.
/// The search does not look behind steps that are not `entered`.
pub(crate) fn needed(
    operations: &[Operation],
    roots: &[Step],
    entered: impl Fn(Step) -> bool,
) -> Vec<bool> {
    let end = roots.iter().max().map_or(0, |&root| root as usize + 1);
    let mut needed = vec![false; end];
    for &root in roots {
        needed[root as usize] = true;
    }
    for place in (0..end).rev() {
        if needed[place] && entered(place as Step) {
            for read in operations[place].reads(place as Step).into_iter().flatten() {
                needed[read as usize] = true;
            }
        }
    }
    needed
}
