//! Compiles sums to few instructions.

use crate::{
    operation::Step,
    program::{Instruction, Register},
};

/// A term of a sum.
#[derive(Clone, Copy, Debug)]
pub(super) enum Term {
    /// `c x`.
    Linear(f64, Step),
    /// `c (a b)`.
    Product(f64, [Step; 2]),
}

/// Emits the instructions of a sum, with its terms in order.
pub(super) fn sum(
    terms: &[Term],
    to: Register,
    at: impl Fn(Step) -> Register,
    instructions: &mut Vec<Instruction>,
) {
    let product = |[a, b]: [Step; 2]| [at(a), at(b)];
    match *terms {
        [Term::Linear(1.0, a), Term::Linear(1.0, b)] => {
            return instructions.push(Instruction::Add(to, [at(a), at(b)]));
        }
        [Term::Linear(1.0, a), Term::Linear(-1.0, b)] => {
            return instructions.push(Instruction::Sub(to, [at(a), at(b)]));
        }
        [Term::Linear(c, x), Term::Product(d, factors)]
        | [Term::Product(d, factors), Term::Linear(c, x)] => {
            let [a, b] = product(factors);
            return instructions.push(Instruction::Mixed(to, [at(x), a, b], [c, d]));
        }
        _ => {}
    }
    let mut rest = terms;
    while let [first, ..] = *rest {
        let begins = rest.len() == terms.len();
        let (instruction, used) = match first {
            Term::Linear(..) => {
                let (mut x, mut c, mut count) = ([0; 4], [0.0; 4], 0);
                while count < 4
                    && let Some(&Term::Linear(factor, step)) = rest.get(count)
                {
                    (x[count], c[count]) = (at(step), factor);
                    count += 1;
                }
                (Instruction::Linear { begins, count: count as u8, x, c }, count)
            }
            Term::Product(..) => {
                let (mut a, mut b, mut c, mut count) = ([0; 2], [0; 2], [0.0; 2], 0);
                while count < 2
                    && let Some(&Term::Product(factor, factors)) = rest.get(count)
                {
                    ([a[count], b[count]], c[count]) = (product(factors), factor);
                    count += 1;
                }
                (Instruction::Products { begins, count: count as u8, a, b, c }, count)
            }
        };
        instructions.push(instruction);
        rest = &rest[used..];
    }
    instructions.push(Instruction::Done(to));
}
