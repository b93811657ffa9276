//! Sums of squares of vectors whose entries are combinations of few functions: pullbacks by decoders.
//!
//! Of `H = C₀ + Σₘ bₘ Cₘ + Σₒ wₒ aₒ aₒᵀ` with constants `wₒ`, where `aₒ = cₒ₀ + Σₐ cₒₐ σₐ(x)` with constant
//! vectors, the products `aₒᵢ aₒⱼ` are more than the entries of `H`, and each depends on all functions `σₐ`.
//! Derivation of what is contracted of the last sum: with `vₒ = aₒᵀd` and `eₒₐ = cₒₐᵀd`,
//!
//! ```text
//! ∂ₖ(aₒᵢ) = Σₐ cₒₐᵢ ∂ₖσₐ,   ∂ₖvₒ = Σₐ eₒₐ ∂ₖσₐ,   ∂ₖ∂ₗvₒ = Σₐ eₒₐ ∂ₖ∂ₗσₐ,
//!
//! dᵀHd = Σₒ wₒ vₒ²,   Hd = Σₒ wₒ vₒ aₒ,
//! Gₖ  = 2 Σₒ wₒ vₒ ∂ₖvₒ                       = 2 Σₐ hₐ ∂ₖσₐ                with hₐ = Σₒ wₒ vₒ eₒₐ,
//! Pᵢₖ = Σₒ wₒ aₒᵢ ∂ₖvₒ + Σₒ wₒ vₒ ∂ₖaₒᵢ         = Σₒ wₒ aₒᵢ ∂ₖvₒ + Σₐ (Σₒ wₒ vₒ cₒₐᵢ) ∂ₖσₐ,
//! Qₖₗ = 2 Σₒ wₒ ∂ₖvₒ ∂ₗvₒ + 2 Σₒ wₒ vₒ ∂ₖ∂ₗvₒ   = 2 Σₒ wₒ ∂ₖvₒ ∂ₗvₒ + 2 Σₐ hₐ ∂ₖ∂ₗσₐ.
//! ```
//!
//! Only the `σₐ` are differentiated. The Jacobian of a network has `cₒₐ = fₒₐ gₐ` with one form `gₐ` for each
//! hidden unit: then `eₒₐ = fₒₐ (gₐᵀd)`, and sums over `o` and `a` have `fₒₐ` alone for factors.

use std::collections::{BTreeMap, HashMap};

use crate::{
    graph::{
        Graph,
        derivative::{Derivatives, Order},
        linear::{Linear, is_linear},
    },
    operation::{Arithmetic, Function, Operation, Step},
};

/// `Σₒ wₒ aₒ aₒᵀ`.
#[derive(Debug, Default)]
pub(super) struct Squares {
    /// The `σₐ`.
    pub(super) functions: Vec<Step>,
    forms: Vec<Form>,
    vectors: Vec<Vector>,
}

/// A constant vector `g` in the direction of which functions count.
#[derive(Debug)]
struct Form {
    function: usize,
    vector: Vec<f64>,
}

/// One `aₒ`.
#[derive(Debug)]
struct Vector {
    weight: f64,
    /// The entries that are no constants, by their coordinates.
    entries: Vec<(usize, Step)>,
    /// `f` by forms: the vector of a form times `f` is `cₒₐ`.
    factors: Vec<(usize, f64)>,
}

/// What is contracted, as in [`Contracted`](super::Contracted).
#[derive(Debug)]
pub(super) struct Sums {
    pub(super) square: Step,
    pub(super) momentum: Vec<Step>,
    pub(super) slope: Vec<Step>,
    pub(super) turn: Vec<Step>,
    pub(super) bend: Vec<Step>,
}

/// An entry of a vector, of which the square is in an entry on the diagonal.
#[derive(Debug)]
struct Candidate {
    coordinate: usize,
    step: Step,
    weight: f64,
    /// This one and those it is multiplied by, in ascending order.
    together: Vec<usize>,
}

/// So many terms are looked at: what has more has a program that is longer than any that is worth it.
const MOST_TERMS: usize = 1 << 16;

impl Graph {
    /// Returns the entries `i ≤ j` of `H` without the squares of vectors, and these; `None` if there are none, or
    /// there is no less to derive by them than by these bases.
    pub(super) fn squares(
        &self,
        gram: &[Step],
        dimension: usize,
        bases: &[Step],
    ) -> Option<(Vec<Linear>, Squares)> {
        let mut left = MOST_TERMS;
        let mut rest: Vec<Linear> =
            gram.iter().map(|&entry| self.flat(entry, &mut left)).collect::<Option<_>>()?;
        let candidates = self.candidates(&rest, dimension)?;
        let mut squares = Squares::default();
        let mut taken = vec![Vec::new(); gram.len()];
        let mut combinations: Vec<Vec<Linear>> = Vec::new();
        for (first, candidate) in candidates.iter().enumerate() {
            let together = &candidate.together;
            // Each with each, or no square of a vector.
            let is_square = together.iter().all(|&other| candidates[other].together == *together);
            if together[0] != first || !is_square {
                continue;
            }
            let entries: Vec<(usize, Step)> = together
                .iter()
                .map(|&one| (candidates[one].coordinate, candidates[one].step))
                .collect();
            let combination = entries
                .iter()
                .map(|&(_, step)| self.flat(step, &mut left))
                .collect::<Option<_>>()?;
            combinations.push(combination);
            for (place, &(i, a)) in entries.iter().enumerate() {
                for &(j, b) in &entries[place..] {
                    taken[i * dimension - i * (i + 1) / 2 + j].push(sorted(a, b));
                }
            }
            let weight = candidate.weight;
            squares.vectors.push(Vector { weight, entries, factors: Vec::new() });
        }
        for (linear, taken) in rest.iter_mut().zip(&mut taken) {
            taken.sort_unstable();
            let is_taken = |step| {
                self.factors(step).is_some_and(|product| taken.binary_search(&product).is_ok())
            };
            linear.terms.retain(|&(step, _)| !is_taken(step));
        }
        squares.combine(&combinations, dimension);
        // Not by the number of all operations: other units have more of those that are linear, and are to have
        // the same roundings.
        let mut own: Vec<Step> =
            rest.iter().flat_map(|linear| &linear.terms).map(|t| t.0).collect();
        own.sort_unstable();
        own.dedup();
        let is_few = own.len() <= bases.len();
        own.extend(&squares.functions);
        let entries: usize = squares.vectors.iter().map(|vector| vector.entries.len()).sum();
        let is_less = self.count_behind(&own) + entries < self.count_behind(bases);
        (is_few && is_less).then_some((rest, squares))
    }

    /// The factors of a product.
    fn factors(&self, step: Step) -> Option<[Step; 2]> {
        match self.operation(step) {
            Operation::Binary(Arithmetic::Mul, a, b) => Some(sorted(a, b)),
            Operation::Of(Function::Sqr, a) => Some([a, a]),
            _ => None,
        }
    }

    /// The steps whose squares are on the diagonal, with those they are multiplied by in the other entries;
    /// `None` if a product may be that of two different pairs.
    fn candidates(&self, entries: &[Linear], dimension: usize) -> Option<Vec<Candidate>> {
        let (mut candidates, mut known) = (Vec::new(), HashMap::new());
        let at = |i: usize, j: usize| &entries[i * dimension - i * (i + 1) / 2 + j].terms;
        for coordinate in 0..dimension {
            for &(step, weight) in at(coordinate, coordinate) {
                if let Operation::Of(Function::Sqr, step) = self.operation(step) {
                    let place = candidates.len();
                    known.insert((coordinate, step), place);
                    candidates.push(Candidate { coordinate, step, weight, together: vec![place] });
                }
            }
        }
        for (i, j) in (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j))) {
            for &(step, weight) in at(i, j) {
                let Some([a, b]) = self.factors(step) else { continue };
                let pair = |a: Step, b: Step| Some([*known.get(&(i, a))?, *known.get(&(j, b))?]);
                let [one, other] = match (pair(a, b), pair(b, a)) {
                    (Some(_), Some(_)) if a != b => return None,
                    (Some(pair), _) | (None, Some(pair)) => pair,
                    (None, None) => continue,
                };
                if candidates[one].weight == weight && candidates[other].weight == weight {
                    candidates[one].together.push(other);
                    candidates[other].together.push(one);
                }
            }
        }
        candidates.iter_mut().for_each(|candidate| candidate.together.sort_unstable());
        Some(candidates)
    }

    /// How many of the steps that these depend on are not linear in what they read.
    fn count_behind(&self, roots: &[Step]) -> usize {
        let end = roots.iter().max().map_or(0, |&root| root as usize + 1);
        let mut is_needed = vec![false; end];
        roots.iter().for_each(|&root| is_needed[root as usize] = true);
        let mut count = 0;
        for step in (0..end).rev().filter(|&step| self.value(step as Step).is_none()) {
            if is_needed[step] {
                let operation = self.operations()[step];
                let reads = operation.reads(step as Step);
                reads.into_iter().flatten().for_each(|read| is_needed[read as usize] = true);
                let is_coordinate = matches!(operation, Operation::Coordinate(_));
                count += usize::from(!is_coordinate && !is_linear(operation));
            }
        }
        count
    }

    /// Adds what is contracted of the squares, by the derivatives of their functions.
    pub(super) fn add_squares(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        order: Order,
        d: &[Step],
        sums: &mut Sums,
    ) {
        let Squares { forms, vectors, .. } = squares;
        // `vₒ` and `wₒ vₒ`.
        let (mut along, mut weighted) = (Vec::new(), Vec::new());
        for vector in vectors {
            let terms: Vec<Step> = vector.entries.iter().map(|&(i, a)| self.mul(a, d[i])).collect();
            let sum = self.sum(terms);
            along.push(sum);
            weighted.push(self.times(sum, vector.weight));
        }
        let square = self.weighted(&weighted, along.into_iter().map(Some));
        sums.square = self.add(sums.square, square);
        for (vector, &weighted) in vectors.iter().zip(&weighted) {
            for &(i, a) in &vector.entries {
                let term = self.mul(a, weighted);
                sums.momentum[i] = self.add(sums.momentum[i], term);
            }
        }
        if order == Order::Zero {
            return;
        }
        // `gᵀd` of each form, and `Σₒ wₒ vₒ f`, which is what the form counts in the sum of all `wₒ vₒ aₒ`.
        let mut forms_along = Vec::new();
        for form in forms {
            let terms: Vec<Step> =
                form.vector.iter().zip(d).map(|(&c, &d)| self.times(d, c)).collect();
            forms_along.push(self.sum(terms));
        }
        let mut terms = vec![Vec::new(); forms.len()];
        for (vector, &weighted) in vectors.iter().zip(&weighted) {
            for &(form, factor) in &vector.factors {
                terms[form].push(self.times(weighted, factor));
            }
        }
        let counts: Vec<Step> = terms.into_iter().map(|terms| self.sum(terms)).collect();
        // `2 hₐ`.
        let mut terms = vec![Vec::new(); squares.functions.len()];
        for (form, (&along, &count)) in forms.iter().zip(forms_along.iter().zip(&counts)) {
            terms[form.function].push(self.mul(along, count));
        }
        let mut doubled = Vec::new();
        for terms in terms {
            let sum = self.sum(terms);
            doubled.push(self.times(sum, 2.0));
        }
        for (k, slope) in sums.slope.iter_mut().enumerate() {
            let first = derivatives.iter().map(|of| of.first.get(&k).copied());
            let sum = self.weighted(&doubled, first);
            *slope = self.add(*slope, sum);
        }
        if order == Order::Second {
            let slopes = self.slopes_along(squares, derivatives, &forms_along, d.len());
            self.add_turn(squares, derivatives, &slopes, &counts, &mut sums.turn);
            self.add_bend(squares, derivatives, &slopes, &doubled, &mut sums.bend);
        }
    }

    /// `∂ₖvₒ` by `[k][o]`.
    fn slopes_along(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        forms_along: &[Step],
        dimension: usize,
    ) -> Vec<Vec<Step>> {
        let mut slopes = Vec::with_capacity(dimension);
        for k in 0..dimension {
            let of_forms = self.times_slopes(squares, derivatives, forms_along, k);
            let mut of_vectors = Vec::with_capacity(squares.vectors.len());
            for vector in &squares.vectors {
                let terms: Vec<Step> = vector
                    .factors
                    .iter()
                    .filter_map(|&(form, factor)| Some(self.times(of_forms[form]?, factor)))
                    .collect();
                of_vectors.push(self.sum(terms));
            }
            slopes.push(of_vectors);
        }
        slopes
    }

    /// A number of each form times `∂ₖ` of its function; `None` is 0.
    fn times_slopes(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        of_forms: &[Step],
        k: usize,
    ) -> Vec<Option<Step>> {
        let pairs = squares.forms.iter().zip(of_forms);
        pairs
            .map(|(form, &number)| {
                let &slope = derivatives[form.function].first.get(&k)?;
                Some(self.mul(number, slope))
            })
            .collect()
    }

    fn add_turn(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        slopes: &[Vec<Step>],
        counts: &[Step],
        turn: &mut [Step],
    ) {
        let dimension = slopes.len();
        for (k, slopes) in slopes.iter().enumerate() {
            let of_forms = self.times_slopes(squares, derivatives, counts, k);
            let mut terms = vec![Vec::new(); dimension];
            for (vector, &slope) in squares.vectors.iter().zip(slopes) {
                for &(i, a) in &vector.entries {
                    let product = self.mul(a, slope);
                    terms[i].push(self.times(product, vector.weight));
                }
            }
            for (i, mut terms) in terms.into_iter().enumerate() {
                for (form, number) in squares.forms.iter().zip(&of_forms) {
                    if let Some(number) = *number
                        && form.vector[i] != 0.0
                    {
                        terms.push(self.times(number, form.vector[i]));
                    }
                }
                let sum = self.sum(terms);
                let place = i * dimension + k;
                turn[place] = self.add(turn[place], sum);
            }
        }
    }

    fn add_bend(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        slopes: &[Vec<Step>],
        doubled: &[Step],
        bend: &mut [Step],
    ) {
        let upper = (0..slopes.len()).flat_map(|k| (k..slopes.len()).map(move |l| (k, l)));
        for (place, bend) in upper.zip(bend) {
            let pairs = slopes[place.0].iter().zip(&slopes[place.1]);
            let mut terms = Vec::with_capacity(squares.vectors.len());
            for ((&one, &other), vector) in pairs.zip(&squares.vectors) {
                let product = self.mul(one, other);
                terms.push(self.times(product, 2.0 * vector.weight));
            }
            let of_slopes = self.sum(terms);
            let second = derivatives.iter().map(|of| of.second.get(&place).copied());
            let of_functions = self.weighted(doubled, second);
            let sum = self.add(of_slopes, of_functions);
            *bend = self.add(*bend, sum);
        }
    }
}

impl Squares {
    /// Takes the vectors apart, of which these are the entries.
    fn combine(&mut self, combinations: &[Vec<Linear>], dimension: usize) {
        let terms = || combinations.iter().flatten().flat_map(|linear| &linear.terms);
        self.functions = terms().map(|&(step, _)| step).collect();
        self.functions.sort_unstable();
        self.functions.dedup();
        // The first form of each function, which others are multiples of.
        let mut firsts: Vec<Option<usize>> = vec![None; self.functions.len()];
        for (vector, combination) in self.vectors.iter_mut().zip(combinations) {
            let mut constants = BTreeMap::<usize, Vec<f64>>::new();
            for (&(i, _), linear) in vector.entries.iter().zip(combination) {
                for (step, factor) in &linear.terms {
                    if let Ok(function) = self.functions.binary_search(step) {
                        constants.entry(function).or_insert_with(|| vec![0.0; dimension])[i] =
                            *factor;
                    }
                }
            }
            for (function, constants) in constants {
                let first = firsts[function].and_then(|first| {
                    Some((first, multiple(&constants, &self.forms[first].vector)?))
                });
                vector.factors.push(first.unwrap_or((self.forms.len(), 1.0)));
                if first.is_none() {
                    firsts[function].get_or_insert(self.forms.len());
                    self.forms.push(Form { function, vector: constants });
                }
            }
        }
    }
}

/// `f` with `c = f g` to rounding.
fn multiple(c: &[f64], g: &[f64]) -> Option<f64> {
    let top = (0..g.len()).max_by(|&i, &j| g[i].abs().total_cmp(&g[j].abs()))?;
    let factor = c[top] / g[top];
    let is_product =
        |(&c, &g): (&f64, &f64)| (c - factor * g).abs() <= 4.0 * f64::EPSILON * c.abs();
    (factor.is_normal() && c.iter().zip(g).all(is_product)).then_some(factor)
}

fn sorted(a: Step, b: Step) -> [Step; 2] {
    [a.min(b), a.max(b)]
}
