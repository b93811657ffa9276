//! The printer, which turns a formula into a text.

use std::fmt;

use crate::{
    Formula,
    operation::{Function, Number, Operation, Pair, Step},
};

/// Each step has its own line and a name. When parsed, the text gives the same formula.
impl<const D: usize> fmt::Display for Formula<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let d = self.dimension();
        let name = |step: Step| Name { step, dimension: d };
        for (place, &operation) in self.operations().iter().enumerate().skip(d) {
            let this = name(place as Step);
            match operation {
                // It is printed on the line of the first.
                Operation::Second => continue,
                Operation::First(..) => write!(f, "{this}, {} = ", name(place as Step + 1))?,
                _ => write!(f, "{this} = ")?,
            }
            match operation {
                Operation::Coordinate(i) => write!(f, "x{}", i + 1)?,
                Operation::Constant(number) => write!(f, "number({})", Literal(number))?,
                Operation::Binary(how, a, b) => {
                    write!(f, "{} {} {}", name(a), how.sign(), name(b))?
                }
                Operation::WithNumber(how, a, number) => {
                    write!(f, "{} {} {}", name(a), how.sign(), Literal(number))?;
                }
                Operation::Powi(a, n) => write!(f, "{}^{n}", name(a))?,
                Operation::Of(Function::Neg, a) => write!(f, "-{}", name(a))?,
                Operation::Of(function, a) => write!(f, "{}({})", function.name(), name(a))?,
                Operation::First(Pair::SinCos, a) => write!(f, "sin_cos({})", name(a))?,
                Operation::First(Pair::SinhCosh, a) => write!(f, "sinh_cosh({})", name(a))?,
                Operation::Table(call) => {
                    write!(f, "table{}", call.table + 1)?;
                    if call.orders != [0; 3] {
                        write!(f, "_")?;
                        call.orders[..usize::from(call.axes)]
                            .iter()
                            .try_for_each(|order| write!(f, "{order}"))?;
                    }
                    for (axis, &argument) in call.arguments().iter().enumerate() {
                        let before = if axis == 0 { "(" } else { ", " };
                        write!(f, "{before}{}", name(argument))?;
                    }
                    f.write_str(")")?;
                }
                Operation::Second => {}
            }
            writeln!(f, ";")?;
        }
        f.write_str("[")?;
        for i in 0..d {
            for j in 0..d {
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

/// Prints the shortest text that parses to this number. Infinities and NaN are printed as a
/// division.
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
