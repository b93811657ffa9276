//! `Wall`: a step `1/(d + f e^z)`, or a multiple of it.

use tautline_formula::{Arithmetic, Formula, Function, Operation, Step};
use tautline_scalar::ANY;

/// A step `c/(d + f e^z)` with positive numbers `d` and `f`.
///
/// In intervals `e^z` is unbounded. The wall is evaluated as a hyperbolic tangent instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wall {
    /// The step `c`; `None` if `c = 1`.
    pub(crate) numerator: Option<Step>,
    pub(crate) d: f64,
    pub(crate) f: f64,
    /// The step `z`.
    pub(crate) z: Step,
}

impl Wall {
    /// Returns the wall that the step at `place` computes, if it does.
    pub(super) fn at(formula: &Formula<ANY>, place: usize) -> Option<Self> {
        let (numerator, denominator) = match formula.operations()[place] {
            Operation::Of(Function::Recip, below) | Operation::Powi(below, -1) => (None, below),
            Operation::Binary(Arithmetic::Div, above, below) => (Some(above), below),
            _ => return None,
        };
        let (d, rest) = with_number(formula, Arithmetic::Add, denominator)?;
        let (f, exponential) = with_number(formula, Arithmetic::Mul, rest).unwrap_or((1.0, rest));
        let (Function::Exp, z) = formula.function(exponential as usize)? else { return None };
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        (is_positive(d) && is_positive(f)).then_some(Self { numerator, d, f, z })
    }
}

/// Returns `c` and `a` if the step is `a + c` or `a c`, in either order, with a number `c`.
fn with_number(formula: &Formula<ANY>, wanted: Arithmetic, step: Step) -> Option<(f64, Step)> {
    let number = |step: Step| match formula.operations()[step as usize] {
        Operation::Constant(c) => Some(c.value()),
        _ => None,
    };
    match formula.operations()[step as usize] {
        Operation::WithNumber(how, a, c) if how == wanted => Some((c.value(), a)),
        Operation::Binary(how, a, b) if how == wanted => match (number(a), number(b)) {
            (Some(c), None) => Some((c, b)),
            (None, Some(c)) => Some((c, a)),
            _ => None,
        },
        _ => None,
    }
}
