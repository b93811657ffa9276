//! Derivatives of expressions.

use std::collections::HashMap;

use crate::{
    graph::{
        Graph,
        derivatives::{By, Derivatives},
    },
    operation::{Arithmetic, Function, Operation, Step, Tabulation, needed},
};

/// The order up to which derivatives are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Zero,
    First,
    Second,
}

/// The variables with respect to which a derivative is taken.
#[derive(Clone, Copy, Debug)]
enum Variables {
    /// This many of the first coordinates.
    Coordinates(usize),
    /// A step on which others depend.
    Step(Step),
}

impl Variables {
    fn are(self, step: Step) -> bool {
        matches!(self, Variables::Step(by) if by == step)
    }
}

impl Graph {
    /// Returns the derivatives of these steps with respect to the `dimension` coordinates of the
    /// point, up to the given order.
    ///
    /// If a step is `F(u)` with a function of one variable, it is differentiated with respect to
    /// `u`, and `u` with respect to the coordinates. A wave that depends on one angle thus has few
    /// derivatives.
    pub(crate) fn derivatives(
        &mut self,
        roots: &[Step],
        dimension: usize,
        order: Order,
    ) -> Vec<Derivatives> {
        if order == Order::Zero {
            return vec![Derivatives::default(); roots.len()];
        }
        let necks: Vec<Option<Step>> = roots.iter().map(|&root| self.neck(root)).collect();
        let inner: Vec<Step> =
            roots.iter().zip(&necks).map(|(&root, neck)| neck.unwrap_or(root)).collect();
        let of_inner = self.forward(&inner, Variables::Coordinates(dimension), order);
        let mut all = Vec::with_capacity(roots.len());
        for ((&root, neck), inner) in roots.iter().zip(necks).zip(&inner) {
            let of_inner = of_inner.get(inner).cloned().unwrap_or_default();
            let Some(neck) = neck else {
                all.push(of_inner);
                continue;
            };
            let outer = self.forward(&[root], Variables::Step(neck), order);
            let outer = outer.get(&root).cloned().unwrap_or_default();
            if !self.keeps_numbers(&outer) {
                let mut direct = self.forward(&[root], Variables::Coordinates(dimension), order);
                all.push(direct.remove(&root).unwrap_or_default());
                continue;
            }
            all.push(self.chain(&of_inner, outer.first(0), outer.second((0, 0)), order));
        }
        all
    }

    /// Returns whether no number in the derivatives of `F` has overflowed or underflowed. In `F′` by
    /// itself factors of a formula may meet that `u′` keeps apart: for `(u · 1e200) · 1e200` it is `∞`.
    fn keeps_numbers(&self, of: &Derivatives) -> bool {
        let roots: Vec<Step> = of.0.values().copied().collect();
        let is_needed = needed(self.operations(), &roots, |_| true);
        let is_lost = |step: usize| match self.operation(step as Step) {
            Operation::Constant(c) | Operation::WithNumber(_, _, c) => {
                !(c.value().is_normal() || c.value() == 0.0)
            }
            _ => false,
        };
        of.first(0).is_some() && !(0..is_needed.len()).any(|step| is_needed[step] && is_lost(step))
    }

    /// Computes the derivatives of `F(u)` from the derivatives of `u`, from `F′` and from `F″`;
    /// `None` is 0.
    fn chain(
        &mut self,
        u: &Derivatives,
        slope: Option<Step>,
        bend: Option<Step>,
        order: Order,
    ) -> Derivatives {
        let mut chained = Derivatives::default();
        if let Some(slope) = slope {
            for (&by, &term) in &u.0 {
                let product = self.mul(term, slope);
                self.add_to(&mut chained, by, product);
            }
        }
        if let (Order::Second, Some(bend)) = (order, bend) {
            for (k, one) in u.firsts() {
                for (l, other) in u.firsts().filter(|&(l, _)| l >= k) {
                    let square = self.mul(one, other);
                    let product = self.mul(square, bend);
                    self.add_to(&mut chained, By::Two(k, l), product);
                }
            }
        }
        chained
    }

    fn add_to(&mut self, sums: &mut Derivatives, by: By, term: Step) {
        if self.is_zero(term) {
            return;
        }
        let sum = match sums.0.get(&by) {
            Some(&sum) => self.add(sum, term),
            None => term,
        };
        if self.is_zero(sum) {
            sums.0.remove(&by);
        } else {
            sums.0.insert(by, sum);
        }
    }

    /// Returns the derivatives of all steps that the roots need, in the order of the graph.
    fn forward(
        &mut self,
        roots: &[Step],
        variables: Variables,
        order: Order,
    ) -> HashMap<Step, Derivatives> {
        let is_needed = needed(self.operations(), roots, |step| !variables.are(step));
        let mut known = HashMap::<Step, Derivatives>::new();
        for step in (0..is_needed.len()).filter(|&step| is_needed[step]) {
            // A full graph returns meaningless steps.
            if self.is_full() {
                break;
            }
            let step = step as Step;
            let of_step = match (self.operation(step), variables) {
                _ if variables.are(step) => self.variable(0),
                (Operation::Coordinate(k), Variables::Coordinates(dimension))
                    if (k as usize) < dimension =>
                {
                    self.variable(k as usize)
                }
                (operation, _) => self.rule(operation, step, &known, order),
            };
            if of_step.firsts().next().is_some() {
                known.insert(step, of_step);
            }
        }
        known
    }

    fn variable(&mut self, k: usize) -> Derivatives {
        Derivatives([(By::One(k), self.constant(1.0))].into())
    }

    /// Computes the derivatives of the step `v` from the derivatives of the steps that it reads.
    fn rule(
        &mut self,
        operation: Operation,
        v: Step,
        known: &HashMap<Step, Derivatives>,
        order: Order,
    ) -> Derivatives {
        let none = Derivatives::default();
        let of = |a: Step| known.get(&a).unwrap_or(&none);
        match operation {
            Operation::Binary(Arithmetic::Add, a, b) => self.combine([of(a), of(b)], [1.0, 1.0]),
            Operation::Binary(Arithmetic::Sub, a, b) => self.combine([of(a), of(b)], [1.0, -1.0]),
            Operation::Binary(Arithmetic::Mul, a, b) => {
                self.product_rule([of(a), of(b)], [a, b], order)
            }
            Operation::Binary(Arithmetic::Div, a, b) => {
                self.quotient_rule([of(a), of(b)], v, b, order)
            }
            Operation::WithNumber(Arithmetic::Mul, a, c) => {
                self.combine([of(a), &none], [c.value(), 0.0])
            }
            Operation::WithNumber(Arithmetic::Div, a, c) => {
                self.map(of(a), |graph, term| graph.over(term, c.value()))
            }
            Operation::WithNumber(Arithmetic::Add, a, _) => of(a).clone(),
            Operation::Of(Function::Neg, a) => self.map(of(a), Self::neg),
            Operation::Of(function, a) => {
                if of(a).0.is_empty() {
                    return none;
                }
                let (slope, bend) = self.slopes(function, a, v);
                self.chain(of(a), Some(slope), Some(bend), order)
            }
            Operation::Table(call) => {
                let of = call.arguments().iter().map(|&argument| of(argument));
                self.table_rule(call, &of.collect::<Vec<_>>(), order)
            }
            _ => none,
        }
    }

    /// For `v = T(u)`: `∂ₖv = Σₐ Tₐ ∂ₖuₐ`, and `∂ₖ∂ₗv = Σₐ Tₐ ∂ₖ∂ₗuₐ + Σₐᵦ Tₐᵦ ∂ₖuₐ ∂ₗuᵦ`.
    fn table_rule(&mut self, call: Tabulation, of: &[&Derivatives], order: Order) -> Derivatives {
        let mut all = Derivatives::default();
        for (axis, of_axis) in of.iter().enumerate().filter(|(_, of)| !of.0.is_empty()) {
            let (slope, bend) = (self.table(call.along(axis)), call.along(axis).along(axis));
            let bend = (order == Order::Second).then(|| self.table(bend));
            for (by, term) in self.chain(of_axis, Some(slope), bend, order).0 {
                self.add_to(&mut all, by, term);
            }
            let others = of.iter().enumerate().skip(axis + 1);
            for (other, of_other) in others.filter(|(_, of)| !of.0.is_empty()) {
                if order == Order::Second {
                    let bend = self.table(call.along(axis).along(other));
                    let crossed = [*of_axis, *of_other];
                    self.add_crossed(&mut all, crossed, |graph, term| graph.mul(term, bend));
                }
            }
        }
        all
    }

    fn map(&mut self, of: &Derivatives, f: impl Fn(&mut Self, Step) -> Step) -> Derivatives {
        Derivatives(of.0.iter().map(|(&by, &term)| (by, f(self, term))).collect())
    }

    fn combine(&mut self, of: [&Derivatives; 2], factors: [f64; 2]) -> Derivatives {
        let mut sum = Derivatives::default();
        for (of, c) in of.into_iter().zip(factors) {
            for (&by, &term) in &of.0 {
                let term = self.times(term, c);
                self.add_to(&mut sum, by, term);
            }
        }
        sum
    }

    fn product_rule(
        &mut self,
        of: [&Derivatives; 2],
        [a, b]: [Step; 2],
        order: Order,
    ) -> Derivatives {
        let mut product = Derivatives::default();
        for (of, other) in of.into_iter().zip([b, a]) {
            for (&by, &term) in &of.0 {
                let term = self.mul(term, other);
                self.add_to(&mut product, by, term);
            }
        }
        if order == Order::Second {
            self.add_crossed(&mut product, of, |_, term| term);
        }
        product
    }

    /// Adds `f(∂ₖa ∂ₗb + ∂ₗa ∂ₖb)`.
    fn add_crossed(
        &mut self,
        sums: &mut Derivatives,
        [of_a, of_b]: [&Derivatives; 2],
        f: impl Fn(&mut Self, Step) -> Step,
    ) {
        let mut crossed = Derivatives::default();
        for (k, one) in of_a.firsts() {
            for (l, other) in of_b.firsts() {
                let term = self.mul(one, other);
                // The two terms are equal.
                let term = if k == l { self.times(term, 2.0) } else { term };
                self.add_to(&mut crossed, By::Two(k.min(l), k.max(l)), term);
            }
        }
        for (by, term) in crossed.0 {
            let term = f(self, term);
            self.add_to(sums, by, term);
        }
    }

    /// For `v = a / b`: `∂v = (∂a − v ∂b)/b`, and `∂∂v = (∂∂a − v ∂∂b − ∂v ∂b − ∂b ∂v)/b`.
    fn quotient_rule(
        &mut self,
        [of_a, of_b]: [&Derivatives; 2],
        v: Step,
        b: Step,
        order: Order,
    ) -> Derivatives {
        let reciprocal = self.apply(Function::Recip, b);
        let mut quotient = of_a.clone();
        for (k, term) in of_b.firsts() {
            let term = self.mul(v, term);
            let term = self.neg(term);
            self.add_to(&mut quotient, By::One(k), term);
        }
        for (by, term) in &mut quotient.0 {
            if matches!(by, By::One(_)) {
                *term = self.mul(*term, reciprocal);
            }
        }
        if order == Order::First {
            return quotient;
        }
        for (by, term) in of_b.seconds() {
            let term = self.mul(v, term);
            let term = self.neg(term);
            self.add_to(&mut quotient, by, term);
        }
        let of_v = quotient.clone();
        self.add_crossed(&mut quotient, [&of_v, of_b], Self::neg);
        for (by, term) in &mut quotient.0 {
            if matches!(by, By::Two(..)) {
                *term = self.mul(*term, reciprocal);
            }
        }
        quotient
    }
}
