//! A formula becomes a text.

use std::fmt;

use crate::{
    Formula,
    operation::{Arithmetic, Function, Number, Operation, Pair, Step},
};

/// Reads back to the same formula, step by step: each has a line and a name.
impl<const D: usize> fmt::Display for Formula<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |step: Step| Name { step, dimension: D };
        for (place, &operation) in self.operations().iter().enumerate().skip(D) {
            let this = name(place as Step);
            match operation {
                // Its line is that of the first.
                Operation::Second => continue,
                Operation::First(..) => write!(f, "{this}, {} = ", name(place as Step + 1))?,
                _ => write!(f, "{this} = ")?,
            }
            match operation {
                Operation::Coordinate(i) => write!(f, "x{}", i + 1)?,
                Operation::Constant(number) => write!(f, "number({})", Literal(number))?,
                Operation::Binary(how, a, b) => write!(f, "{} {} {}", name(a), sign(how), name(b))?,
                Operation::WithNumber(how, a, number) => {
                    write!(f, "{} {} {}", name(a), sign(how), Literal(number))?;
                }
                Operation::Powi(a, n) => write!(f, "{}^{n}", name(a))?,
                Operation::Of(Function::Neg, a) => write!(f, "-{}", name(a))?,
                Operation::Of(function, a) => write!(f, "{}({})", of(function), name(a))?,
                Operation::First(Pair::SinCos, a) => write!(f, "sin_cos({})", name(a))?,
                Operation::First(Pair::SinhCosh, a) => write!(f, "sinh_cosh({})", name(a))?,
                Operation::Second => {}
            }
            writeln!(f, ";")?;
        }
        f.write_str("[")?;
        for i in 0..D {
            for j in 0..D {
                let before = if j > 0 {
                    ", "
                } else if i > 0 {
                    "; "
                } else {
                    ""
                };
                write!(f, "{before}{}", name(self.entry(i, j)))?;
            }
        }
        f.write_str("]")
    }
}

/// The name of a step.
struct Name {
    step: Step,
    dimension: usize,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.step as usize {
            i if i < self.dimension => write!(f, "x{}", i + 1),
            i => write!(f, "s{}", i - self.dimension + 1),
        }
    }
}

/// A number, as the shortest text that is read back to it; what is no number by an operation that makes it.
struct Literal(Number);

impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.value() {
            value if value == f64::INFINITY => f.write_str("(1/0)"),
            value if value == f64::NEG_INFINITY => f.write_str("(-1/0)"),
            value if value.is_nan() => f.write_str("(0/0)"),
            value => write!(f, "{value:?}"),
        }
    }
}

fn sign(how: Arithmetic) -> char {
    match how {
        Arithmetic::Add => '+',
        Arithmetic::Sub => '-',
        Arithmetic::Mul => '*',
        Arithmetic::Div => '/',
    }
}

fn of(function: Function) -> &'static str {
    match function {
        Function::Neg => "-",
        Function::Sqr => "sqr",
        Function::Recip => "recip",
        Function::Sqrt => "sqrt",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Atan => "atan",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
    }
}
