//! Expressions as linear combinations of other expressions.

use std::collections::{BTreeMap, HashMap};

use crate::{
    graph::Graph,
    operation::{Arithmetic, Function, Operation, Step, needed},
};

/// The combination `c + Σ cₘ bₘ`. The steps `bₘ` are in ascending order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Linear {
    pub(crate) constant: f64,
    pub(crate) terms: Vec<(Step, f64)>,
}

impl Linear {
    pub(crate) fn step(step: Step) -> Self {
        Self { constant: 0.0, terms: vec![(step, 1.0)] }
    }

    /// Returns `None` if a term vanishes, since an undefined term minus itself must stay undefined.
    fn plus(&self, other: &Self, sign: f64) -> Option<Self> {
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let (mut mine, mut others) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        loop {
            let (a, b) = (mine.peek().map(|term| term.0), others.peek().map(|term| term.0));
            let (from_mine, from_others) = match (a, b) {
                (None, None) => break,
                (Some(a), Some(b)) => (a <= b, b <= a),
                (a, b) => (a.is_some(), b.is_some()),
            };
            let a = if from_mine { mine.next() } else { None };
            let b = if from_others { others.next() } else { None };
            let step = a.or(b).map_or(0, |term| term.0);
            let factor = a.map_or(0.0, |term| term.1) + b.map_or(0.0, |term| sign * term.1);
            terms.push((step, factor));
        }
        Self { constant: self.constant + sign * other.constant, terms }.checked()
    }

    /// Returns `None` if a factor overflows or underflows.
    fn times(&self, c: f64) -> Option<Self> {
        let mut scaled = self.clone();
        scaled.constant *= c;
        scaled.terms.iter_mut().for_each(|(_, factor)| *factor *= c);
        scaled.checked()
    }

    fn checked(self) -> Option<Self> {
        let is_sound =
            self.constant.is_finite() && self.terms.iter().all(|term| term.1.is_normal());
        is_sound.then_some(self)
    }
}

/// A number of terms larger than that of any matrix for which this helps.
const MOST_TERMS: usize = 64;

impl Graph {
    /// Returns these steps as linear combinations of steps that are not linear combinations.
    pub(crate) fn linear(&self, roots: &[Step]) -> Vec<Linear> {
        let mut known = HashMap::<Step, Linear>::new();
        let is_needed = needed(self.operations(), roots, |step| is_linear(self.operation(step)));
        for step in (0..is_needed.len()).filter(|&step| is_needed[step]) {
            let operation = self.operations()[step];
            let step = step as Step;
            let of = |a: Step| known.get(&a).cloned().unwrap_or_else(|| Linear::step(a));
            let combination = match operation {
                Operation::Constant(c) => Some(Linear { constant: c.value(), ..Linear::default() }),
                Operation::Binary(Arithmetic::Add, a, b) => of(a).plus(&of(b), 1.0),
                Operation::Binary(Arithmetic::Sub, a, b) => of(a).plus(&of(b), -1.0),
                Operation::WithNumber(Arithmetic::Add, a, c) => {
                    let of_a = of(a);
                    Linear { constant: of_a.constant + c.value(), ..of_a }.checked()
                }
                Operation::WithNumber(Arithmetic::Mul, a, c) => of(a).times(c.value()),
                Operation::WithNumber(Arithmetic::Div, a, c) => of(a).times(c.value().recip()),
                Operation::Of(Function::Neg, a) => of(a).times(-1.0),
                _ => None,
            };
            // A small difference of coordinates and numbers is exact, so it stays together.
            let is_affine = |linear: &Linear| {
                let is_coordinate =
                    |term: &(Step, f64)| matches!(self.operation(term.0), Operation::Coordinate(_));
                linear.terms.iter().any(is_coordinate)
            };
            let combination =
                combination.filter(|linear| linear.terms.len() <= MOST_TERMS && !is_affine(linear));
            known.insert(step, combination.unwrap_or_else(|| Linear::step(step)));
        }
        roots.iter().map(|root| known.get(root).cloned().unwrap_or_default()).collect()
    }

    /// Returns one step as a linear combination of any length. Returns `None` if a term vanishes,
    /// if a factor overflows or underflows, or if more than `left` steps would be visited.
    /// Subtracts the number of visited steps from `left`.
    ///
    /// It works from the sum to its terms, in time linear in their number.
    pub(super) fn flat(&self, root: Step, left: &mut usize) -> Option<Linear> {
        let mut open = BTreeMap::from([(root, 1.0_f64)]);
        let mut flat = Linear::default();
        // A step is popped after all steps that read it.
        while let Some((step, factor)) = open.pop_last() {
            *left = left.checked_sub(1)?;
            if !factor.is_normal() {
                return None;
            }
            let mut add = |step: Step, factor: f64| *open.entry(step).or_default() += factor;
            match self.operation(step) {
                Operation::Constant(c) => flat.constant += factor * c.value(),
                operation if self.is_atom(operation, step) => flat.terms.push((step, factor)),
                Operation::Binary(how, a, b) => {
                    add(a, factor);
                    add(b, if how == Arithmetic::Sub { -factor } else { factor });
                }
                Operation::WithNumber(Arithmetic::Add, a, c) => {
                    flat.constant += factor * c.value();
                    add(a, factor);
                }
                Operation::WithNumber(Arithmetic::Mul, a, c) => add(a, factor * c.value()),
                Operation::WithNumber(Arithmetic::Div, a, c) => add(a, factor * c.value().recip()),
                Operation::Of(Function::Neg, a) => add(a, -factor),
                _ => flat.terms.push((step, factor)),
            }
        }
        flat.terms.reverse();
        flat.checked()
    }

    /// Returns whether an operation is not linear, or must stay together because it has a
    /// coordinate as a term or a factor that is not normal.
    fn is_atom(&self, operation: Operation, step: Step) -> bool {
        let is_coordinate = |read| matches!(self.operation(read), Operation::Coordinate(_));
        !is_linear(operation)
            || matches!(operation, Operation::WithNumber(Arithmetic::Mul, _, c) if !c.value().is_normal())
            || operation.reads(step).into_iter().flatten().any(is_coordinate)
    }
}

pub(super) fn is_linear(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Binary(Arithmetic::Add | Arithmetic::Sub, ..)
            | Operation::WithNumber(..)
            | Operation::Of(Function::Neg, _)
    )
}
