//! Random formulas are recorded bit for bit.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{cases, seed};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::random::Random;

/// A formula in two variables.
#[derive(Debug)]
enum Tree {
    X(usize),
    Number(f64),
    Two(usize, Box<Tree>, Box<Tree>),
    WithNumber(usize, Box<Tree>, f64),
    NumberWith(usize, f64, Box<Tree>),
    Powi(Box<Tree>, i32),
    Of(usize, Box<Tree>),
}

fn arithmetic<S, T, R>(which: usize, a: S, b: T) -> R
where
    S: std::ops::Add<T, Output = R>
        + std::ops::Sub<T, Output = R>
        + std::ops::Mul<T, Output = R>
        + std::ops::Div<T, Output = R>,
{
    match which {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        _ => a / b,
    }
}

impl Tree {
    fn random(random: &mut Random, depth: usize) -> Self {
        let kind = random.below(if depth == 0 { 2 } else { 9 });
        let mut below = || Box::new(Self::random(random, depth - 1));
        match kind {
            0 => Tree::X(random.below(2)),
            1 => Tree::Number(random.number()),
            2 | 3 => {
                let (a, b) = (below(), below());
                Tree::Two(random.below(4), a, b)
            }
            4 => {
                let a = below();
                Tree::WithNumber(random.below(4), a, random.number())
            }
            5 => {
                let a = below();
                Tree::NumberWith(random.below(4), random.number(), a)
            }
            6 => {
                let a = below();
                Tree::Powi(a, random.below(9) as i32 - 4)
            }
            _ => {
                let a = below();
                Tree::Of(random.below(17), a)
            }
        }
    }

    fn at<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
        match self {
            Tree::X(i) => x[*i],
            Tree::Number(value) => S::constant(*value),
            Tree::Two(which, a, b) => arithmetic(*which, a.at(x), b.at(x)),
            Tree::WithNumber(which, a, c) => arithmetic(*which, a.at(x), *c),
            Tree::NumberWith(0, c, a) => *c + a.at(x),
            Tree::NumberWith(1, c, a) => *c - a.at(x),
            Tree::NumberWith(2, c, a) => *c * a.at(x),
            Tree::NumberWith(_, c, a) => *c / a.at(x),
            Tree::Powi(a, n) => a.at(x).powi(*n),
            Tree::Of(which, a) => {
                let a = a.at(x);
                match which {
                    0 => -a,
                    1 => a.sqr(),
                    2 => a.recip(),
                    3 => a.sqrt(),
                    4 => a.exp(),
                    5 => a.ln(),
                    6 => a.sin(),
                    7 => a.cos(),
                    8 => a.tan(),
                    9 => a.atan(),
                    10 => a.sinh(),
                    11 => a.cosh(),
                    12 => a.tanh(),
                    13 => a.sin_cos().0,
                    14 => a.sin_cos().1,
                    15 => a.sinh_cosh().0,
                    _ => a.sinh_cosh().1,
                }
            }
        }
    }
}

/// `[[t, u], [u, t]]` with two trees.
pub(crate) struct Trees([Tree; 2]);

impl Trees {
    pub(crate) fn random(random: &mut Random, depth: usize) -> Self {
        Self([(); 2].map(|()| Tree::random(random, depth)))
    }
}

impl Metric<2> for Trees {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let [t, u] = [self.0[0].at(x), self.0[1].at(x)];
        SMatrix::<S, 2, 2>::new(t, u, u, t)
    }
}

/// Compares numbers, and their texts if the numbers differ, so that NaN equals NaN.
fn assert_same<S: Scalar>(trees: &Trees, formula: &Formula<2>, x: [S; 2]) {
    let x = SVector::from(x);
    let (found, expected) = (formula.gram(&x), trees.gram(&x));
    if found != expected {
        assert_eq!(format!("{found:?}"), format!("{expected:?}"), "{:?}", trees.0);
    }
}

#[test]
fn random_formulas_are_recorded_to_the_bit() {
    let mut random = Random(seed(1902));
    let (mut finite, cases) = (0, cases(100_000));
    for _ in 0..cases {
        let trees = Trees([0, 1].map(|_| {
            let depth = random.below(6);
            Tree::random(&mut random, depth)
        }));
        let formula = Formula::record(&trees).expect("no comparison");
        let x = [random.number(), random.number()];
        let sides = x.map(|x| Interval::new(x, x + 0.25).expect("ordered ends"));
        assert_same(&trees, &formula, x);
        assert_same(&trees, &formula, sides);
        assert_same(&trees, &formula, Jet2::variables(&sides));
        finite +=
            u32::from(formula.gram(&SVector::from(sides)).iter().all(|side| side.is_finite()));
    }
    // Most values are defined.
    assert!(finite > cases / 2, "{finite} of {cases}");
}
