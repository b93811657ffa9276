//! Derivatives of expressions.

use std::collections::{BTreeMap, HashMap};

use crate::{
    graph::Graph,
    operation::{Arithmetic, Function, Operation, Step},
};

/// First and second derivatives by the variables; those that are 0 are not there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Derivatives {
    /// `∂ₖ` by `k`.
    pub(crate) first: BTreeMap<usize, Step>,
    /// `∂ₖ∂ₗ` by `(k, l)` with `k ≤ l`, if they are asked for.
    pub(crate) second: BTreeMap<(usize, usize), Step>,
}

/// What is differentiated by.
#[derive(Clone, Copy, Debug)]
enum Variables {
    /// The coordinates of the point, so many.
    Coordinates(usize),
    /// One step, on which others depend.
    Step(Step),
}

impl Graph {
    /// Returns the derivatives of these steps by the `dimension` coordinates of the point, up to the second
    /// ones or only the first.
    ///
    /// `F(u)` with a function of one variable is differentiated by `u`, then `u` by the coordinates: where a
    /// wave passes through one angle, its derivatives are few.
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
            let slope = outer.first.get(&0).copied();
            let bend = outer.second.get(&(0, 0)).copied();
            all.push(self.chain(&of_inner, slope, bend, order));
        }
        all
    }

    /// The derivatives of `F(u)` by those of `u`, with `F′` and `F″`; `None` is 0.
    fn chain(
        &mut self,
        u: &Derivatives,
        slope: Option<Step>,
        bend: Option<Step>,
        order: Order,
    ) -> Derivatives {
        let mut chained = Derivatives::default();
        if let Some(slope) = slope {
            for (&k, &first) in &u.first {
                let product = self.mul(first, slope);
                self.add_to(&mut chained.first, k, product);
            }
        }
        if order == Order::First {
            return chained;
        }
        if let Some(slope) = slope {
            for (&place, &second) in &u.second {
                let product = self.mul(second, slope);
                self.add_to(&mut chained.second, place, product);
            }
        }
        if let Some(bend) = bend {
            for (&k, &one) in &u.first {
                for (&l, &other) in u.first.range(k..) {
                    let square = self.mul(one, other);
                    let product = self.mul(square, bend);
                    self.add_to(&mut chained.second, (k, l), product);
                }
            }
        }
        chained
    }

    fn add_to<K: Ord>(&mut self, sums: &mut BTreeMap<K, Step>, place: K, term: Step) {
        if self.is_zero(term) {
            return;
        }
        let sum = match sums.get(&place) {
            Some(&sum) => self.add(sum, term),
            None => term,
        };
        if self.is_zero(sum) {
            sums.remove(&place);
        } else {
            sums.insert(place, sum);
        }
    }

    /// The derivatives of all steps that are needed for the roots, one after the other.
    fn forward(
        &mut self,
        roots: &[Step],
        variables: Variables,
        order: Order,
    ) -> HashMap<Step, Derivatives> {
        let end = roots.iter().max().map_or(0, |&root| root as usize + 1);
        let mut is_needed = vec![false; end];
        for &root in roots {
            is_needed[root as usize] = true;
        }
        for step in (0..end).rev().filter(|&step| !is_variable(variables, step)) {
            if is_needed[step] {
                for read in self.operations()[step].reads(step as Step).into_iter().flatten() {
                    is_needed[read as usize] = true;
                }
            }
        }
        let mut known = HashMap::<Step, Derivatives>::new();
        for step in (0..end).filter(|&step| is_needed[step]) {
            // What is made from here on means nothing.
            if self.is_full() {
                break;
            }
            let of_step = match (self.operations()[step], variables) {
                (_, Variables::Step(by)) if by as usize == step => self.variable(0),
                (Operation::Coordinate(k), Variables::Coordinates(dimension))
                    if (k as usize) < dimension =>
                {
                    self.variable(k as usize)
                }
                (operation, _) => self.rule(operation, step as Step, &known, order),
            };
            if !of_step.first.is_empty() {
                known.insert(step as Step, of_step);
            }
        }
        known
    }

    fn variable(&mut self, k: usize) -> Derivatives {
        let one = self.constant(1.0);
        Derivatives { first: BTreeMap::from([(k, one)]), second: BTreeMap::new() }
    }

    /// The derivatives of the step `v` by those of what it reads.
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
                if of(a).first.is_empty() {
                    return none;
                }
                let (slope, bend) = self.slopes(function, a, v);
                self.chain(of(a), Some(slope), Some(bend), order)
            }
            _ => none,
        }
    }

    fn map(&mut self, of: &Derivatives, f: impl Fn(&mut Self, Step) -> Step) -> Derivatives {
        let mut mapped = of.clone();
        mapped.first.values_mut().for_each(|term| *term = f(self, *term));
        mapped.second.values_mut().for_each(|term| *term = f(self, *term));
        mapped
    }

    fn combine(&mut self, of: [&Derivatives; 2], factors: [f64; 2]) -> Derivatives {
        let mut sum = Derivatives::default();
        for (of, c) in of.into_iter().zip(factors) {
            for (&place, &term) in &of.first {
                let term = self.times(term, c);
                self.add_to(&mut sum.first, place, term);
            }
            for (&place, &term) in &of.second {
                let term = self.times(term, c);
                self.add_to(&mut sum.second, place, term);
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
        let [of_a, of_b] = of;
        let mut product = Derivatives::default();
        for (of, other) in [(of_a, b), (of_b, a)] {
            for (&place, &term) in &of.first {
                let term = self.mul(term, other);
                self.add_to(&mut product.first, place, term);
            }
            for (&place, &term) in &of.second {
                let term = self.mul(term, other);
                self.add_to(&mut product.second, place, term);
            }
        }
        if order == Order::Second {
            self.add_crossed(&mut product.second, of, |_, term| term);
        }
        product
    }

    /// Adds `f(∂ₖa ∂ₗb + ∂ₗa ∂ₖb)`.
    fn add_crossed(
        &mut self,
        sums: &mut BTreeMap<(usize, usize), Step>,
        [of_a, of_b]: [&Derivatives; 2],
        f: impl Fn(&mut Self, Step) -> Step,
    ) {
        let mut crossed = BTreeMap::new();
        for (&k, &one) in &of_a.first {
            for (&l, &other) in &of_b.first {
                let term = self.mul(one, other);
                // Twice, where both are the same.
                let term = if k == l { self.times(term, 2.0) } else { term };
                self.add_to(&mut crossed, (k.min(l), k.max(l)), term);
            }
        }
        for (place, term) in crossed {
            let term = f(self, term);
            self.add_to(sums, place, term);
        }
    }

    /// Of `v = a / b`: `∂v = (∂a − v ∂b)/b`, and `∂∂v = (∂∂a − v ∂∂b − ∂v ∂b − ∂b ∂v)/b`.
    fn quotient_rule(
        &mut self,
        [of_a, of_b]: [&Derivatives; 2],
        v: Step,
        b: Step,
        order: Order,
    ) -> Derivatives {
        let reciprocal = self.apply(Function::Recip, b);
        let mut quotient = of_a.clone();
        for (&place, &term) in &of_b.first {
            let term = self.mul(v, term);
            let term = self.neg(term);
            self.add_to(&mut quotient.first, place, term);
        }
        for term in quotient.first.values_mut() {
            *term = self.mul(*term, reciprocal);
        }
        if order == Order::First {
            return quotient;
        }
        for (&place, &term) in &of_b.second {
            let term = self.mul(v, term);
            let term = self.neg(term);
            self.add_to(&mut quotient.second, place, term);
        }
        let Derivatives { first, mut second } = quotient;
        let quotient = Derivatives { first, second: BTreeMap::new() };
        self.add_crossed(&mut second, [&quotient, of_b], Self::neg);
        for term in second.values_mut() {
            *term = self.mul(*term, reciprocal);
        }
        Derivatives { second, ..quotient }
    }

    /// `f′` and `f″` at `x`, with `v = f(x)`.
    fn slopes(&mut self, function: Function, x: Step, v: Step) -> (Step, Step) {
        match function {
            Function::Neg => (self.constant(-1.0), self.constant(0.0)),
            Function::Sqr => (self.times(x, 2.0), self.constant(2.0)),
            Function::Recip => {
                let square = self.mul(v, v);
                let cube = self.mul(square, v);
                (self.neg(square), self.times(cube, 2.0))
            }
            Function::Sqrt => {
                let reciprocal = self.apply(Function::Recip, v);
                let slope = self.times(reciprocal, 0.5);
                let bend = self.div(slope, x);
                (slope, self.times(bend, -0.5))
            }
            Function::Exp => (v, v),
            Function::Ln => {
                let slope = self.apply(Function::Recip, x);
                let square = self.mul(slope, slope);
                (slope, self.neg(square))
            }
            Function::Sin => (self.apply(Function::Cos, x), self.neg(v)),
            Function::Cos => {
                let sine = self.apply(Function::Sin, x);
                (self.neg(sine), self.neg(v))
            }
            Function::Tan => {
                let square = self.mul(v, v);
                let slope = self.plus(square, 1.0);
                let bend = self.mul(v, slope);
                (slope, self.times(bend, 2.0))
            }
            Function::Atan => {
                let square = self.mul(x, x);
                let sum = self.plus(square, 1.0);
                let slope = self.apply(Function::Recip, sum);
                let square = self.mul(slope, slope);
                let bend = self.mul(x, square);
                (slope, self.times(bend, -2.0))
            }
            Function::Sinh => (self.apply(Function::Cosh, x), v),
            Function::Cosh => (self.apply(Function::Sinh, x), v),
            Function::Tanh => {
                // Not 1 − v², of which nothing is left where v is 1 to rounding.
                let cosh = self.apply(Function::Cosh, x);
                let reciprocal = self.apply(Function::Recip, cosh);
                let slope = self.mul(reciprocal, reciprocal);
                let bend = self.mul(v, slope);
                (slope, self.times(bend, -2.0))
            }
        }
    }
}

/// Up to which derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Zero,
    First,
    Second,
}

fn is_variable(variables: Variables, step: usize) -> bool {
    matches!(variables, Variables::Step(by) if by as usize == step)
}
