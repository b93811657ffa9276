//! `Formula`: random formulas in two variables, with every operation of `Scalar`.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

use tautline_scalar::{Fast, Jet1, Jet2, Rigorous, Scalar};

use crate::{
    precise::{Cell, Precise, Tally, Value},
    reference::{Function, Random},
};

/// A formula as a tree.
#[derive(Clone, Debug)]
pub(crate) enum Formula {
    Variable(usize),
    Constant(f64),
    Binary(char, Box<Formula>, Box<Formula>),
    /// An operator with a number on its right.
    WithNumber(char, Box<Formula>, f64),
    Negative(Box<Formula>),
    Square(Box<Formula>),
    Power(Box<Formula>, i32),
    Reciprocal(Box<Formula>),
    Root(Box<Formula>),
    /// `½ s² + c`, where `s` and `c` are sine and cosine evaluated together (`true`), or `sinh` and
    /// `cosh`.
    Pair(bool, Box<Formula>),
    Of(Function, Box<Formula>),
}

use Formula::{
    Binary, Constant, Negative, Of, Pair, Power, Reciprocal, Root, Square, Variable, WithNumber,
};

impl Formula {
    /// Returns a random formula of at most this depth.
    pub(crate) fn random(depth: u32, random: &mut Random) -> Self {
        if depth == 0 || random.bits().is_multiple_of(16) {
            return match random.bits() % 4 {
                0 => Constant(number(random)),
                _ => Variable(random.bits() as usize % 2),
            };
        }
        let part = |random: &mut Random| Box::new(Self::random(depth - 1, random));
        match random.bits() % 16 {
            0..=3 => {
                let operator = ['+', '-', '*', '*'][random.bits() as usize % 4];
                Binary(operator, part(random), part(random))
            }
            4 => Binary('/', part(random), Box::new(Self::domain(depth - 1, random))),
            5 | 6 => {
                let operator = ['+', '-', '*', '/'][random.bits() as usize % 4];
                WithNumber(operator, part(random), number(random))
            }
            7 => Negative(part(random)),
            8 => Square(part(random)),
            9 => {
                let n = (random.bits() % 13) as i32 - 5;
                let base =
                    if n < 0 { Box::new(Self::domain(depth - 1, random)) } else { part(random) };
                Power(base, n)
            }
            10 => Reciprocal(Box::new(Self::domain(depth - 1, random))),
            11 => Root(Box::new(Self::domain(depth - 1, random))),
            12 => Pair(random.bits() & 1 == 0, part(random)),
            _ => {
                let f = Function::ALL[random.bits() as usize % Function::ALL.len()];
                let argument = if f == Function::Ln {
                    Box::new(Self::domain(depth - 1, random))
                } else {
                    part(random)
                };
                Of(f, argument)
            }
        }
    }

    /// Returns a divisor or radicand: three times in four `f² + c` with `c > 0`, otherwise any
    /// formula.
    fn domain(depth: u32, random: &mut Random) -> Self {
        let part = Self::random(depth.saturating_sub(1), random);
        if random.bits().is_multiple_of(4) {
            part
        } else {
            WithNumber('+', Box::new(Square(Box::new(part))), random.between(0.1, 2.0))
        }
    }

    pub(crate) fn of<S: Scalar>(&self, x: &[S; 2]) -> S {
        match self {
            Variable(i) => x[*i],
            Constant(c) => S::constant(*c),
            Binary('+', a, b) => a.of(x) + b.of(x),
            Binary('-', a, b) => a.of(x) - b.of(x),
            Binary('*', a, b) => a.of(x) * b.of(x),
            Binary(_, a, b) => a.of(x) / b.of(x),
            WithNumber('+', a, c) => a.of(x) + *c,
            WithNumber('-', a, c) => a.of(x) - *c,
            WithNumber('*', a, c) => a.of(x) * *c,
            WithNumber(_, a, c) => a.of(x) / *c,
            Negative(a) => -a.of(x),
            Square(a) => a.of(x).sqr(),
            Power(a, n) => a.of(x).powi(*n),
            Reciprocal(a) => a.of(x).recip(),
            Root(a) => a.of(x).sqrt(),
            Pair(circular, a) => {
                let (s, c) = if *circular { a.of(x).sin_cos() } else { a.of(x).sinh_cosh() };
                s.sqr() * 0.5 + c
            }
            Of(f, a) => f.of(a.of(x)),
        }
    }
}

/// Returns a nonzero constant: a multiple of ½, a decimal or any number.
fn number(random: &mut Random) -> f64 {
    match random.bits() % 3 {
        0 => (random.bits() % 8 + 1) as f64 * random.sign() * 0.5,
        1 => random.sign() * [0.1, 0.3, 0.7, 1.1, 3.3][random.bits() as usize % 5],
        _ => random.sign() * random.with_exponent(-3, 3),
    }
}

fn second_order<S: Scalar>(formula: &Formula, x: [S; 2]) -> [S; 6] {
    let y = formula.of(&Jet2::variables(&x));
    [y.value(), y.first(0), y.first(1), y.second(0, 0), y.second(0, 1), y.second(1, 1)]
}

/// Returns the same, computed by nested first derivatives.
fn nested<S: Scalar>(formula: &Formula, x: [S; 2]) -> [S; 6] {
    let inner = Jet1::<S, 2>::variables(&x);
    let y = formula.of(&Jet1::<Jet1<S, 2>, 2>::variables(&inner));
    let second = |i: usize, j: usize| y.first(i).first(j);
    let value = y.value();
    [value.value(), value.first(0), value.first(1), second(0, 0), second(0, 1), second(1, 1)]
}

/// Compares a formula and its derivatives over eight boxes with their values at two points of each.
#[track_caller]
pub(crate) fn attempt(formula: &Formula, random: &mut Random, tally: &mut Tally) {
    for _ in 0..8 {
        let cell = Cell::<2>::random(3.0, random);
        let over = cell.intervals::<Rigorous>();
        let plain = formula.of(&over);
        let (rigorous, twice) = (second_order(formula, over), nested(formula, over));
        let fast = second_order(formula, cell.intervals::<Fast>());
        for _ in 0..2 {
            Precise::forget_all();
            let point = cell.point(random);
            let at = second_order(formula, point);
            let compare = |name: &str, k: usize, outcome: Result<(), String>| {
                outcome.unwrap_or_else(|miss| {
                    panic!("{formula:?}\n{name} {k}: {miss}\nin {cell:?} at {point:?}")
                });
            };
            compare("plain", 0, tally.compare(plain, at[0]));
            // Operations that ignore the value of their argument must keep it undefined.
            if matches!(at[0].value(), Value::Undefined) {
                for (k, x) in [plain.powi(0), plain * 0.0, plain.atan()].into_iter().enumerate() {
                    compare("after the undefined", k, tally.compare(x, at[0]));
                }
            }
            for k in 0..6 {
                compare("Jet2", k, tally.compare(rigorous[k], at[k]));
                compare("fast Jet2", k, tally.compare(fast[k], at[k]));
                compare("nested Jet1", k, tally.compare(twice[k], at[k]));
            }
        }
    }
}
