//! Sums of squares of vectors whose entries combine few functions, such as pullbacks by decoders.
//!
//! Let `H = C₀ + Σₘ bₘ Cₘ + Σₒ wₒ aₒ aₒᵀ` with constants `wₒ`, where `aₒ = cₒ₀ + Σₐ cₒₐ σₐ(x)` with
//! constant vectors. There are more products `aₒᵢ aₒⱼ` than entries of `H`, and each depends on all
//! functions `σₐ`. The last sum is therefore contracted with `vₒ = aₒᵀd` and `eₒₐ = cₒₐᵀd`:
//!
//! ```text
//! ∂ₖ(aₒᵢ) = Σₐ cₒₐᵢ ∂ₖσₐ,   ∂ₖvₒ = Σₐ eₒₐ ∂ₖσₐ,   ∂ₖ∂ₗvₒ = Σₐ eₒₐ ∂ₖ∂ₗσₐ,
//!
//! dᵀHd = Σₒ wₒ vₒ²,   Hd = Σₒ wₒ vₒ aₒ,
//! Gₖ  = 2 Σₒ wₒ vₒ ∂ₖvₒ                       = 2 Σₐ hₐ ∂ₖσₐ              with hₐ = Σₒ wₒ vₒ eₒₐ,
//! Pᵢₖ = Σₒ wₒ aₒᵢ ∂ₖvₒ + Σₒ wₒ vₒ ∂ₖaₒᵢ         = Σₒ wₒ aₒᵢ ∂ₖvₒ + Σₐ (Σₒ wₒ vₒ cₒₐᵢ) ∂ₖσₐ,
//! Qₖₗ = 2 Σₒ wₒ ∂ₖvₒ ∂ₗvₒ + 2 Σₒ wₒ vₒ ∂ₖ∂ₗvₒ   = 2 Σₒ wₒ ∂ₖvₒ ∂ₗvₒ + 2 Σₐ hₐ ∂ₖ∂ₗσₐ.
//! ```
//!
//! Only the `σₐ` are differentiated. The Jacobian of a network has `cₒₐ = fₒₐ gₐ` with one form
//! `gₐ` for each hidden unit. In that case `eₒₐ = fₒₐ (gₐᵀd)`, and sums over `o` and `a` contain
//! only the factors `fₒₐ`.

mod contraction;

use std::collections::{BTreeMap, HashMap};

use crate::{
    graph::{
        Graph,
        linear::{Linear, is_linear},
    },
    operation::{Arithmetic, Function, Operation, Step, needed},
};

/// The sum `Σₒ wₒ aₒ aₒᵀ`.
#[derive(Debug, Default)]
pub(super) struct Squares {
    /// The functions `σₐ`.
    pub(super) functions: Vec<Step>,
    forms: Vec<Form>,
    vectors: Vec<Vector>,
}

/// A constant vector `g`, the direction of a function.
#[derive(Debug)]
struct Form {
    function: usize,
    vector: Vec<f64>,
}

/// One vector `aₒ`.
#[derive(Debug)]
struct Vector {
    weight: f64,
    /// The nonzero entries with their coordinates.
    entries: Vec<(usize, Step)>,
    /// The factors `f` by forms: `cₒₐ` is the vector of a form times `f`.
    factors: Vec<(usize, f64)>,
}

/// An entry of a vector. Its square is a term on the diagonal.
#[derive(Debug)]
struct Candidate {
    coordinate: usize,
    step: Step,
    weight: f64,
    /// This candidate and the candidates that it is multiplied by, in ascending order.
    together: Vec<usize>,
}

/// The largest number of terms, a quarter of the operations of the largest [graph](Graph). A decoder with 32
/// hidden units and 42 outputs on 8 coordinates has 70 000.
const MOST_TERMS: usize = 1 << 20;

impl Graph {
    /// Splits squares of vectors off the entries `i ≤ j` of `H`, and returns the rest and the
    /// squares. Returns `None` if there are none, or if no fewer steps than these bases remain to
    /// be derived.
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
            // The square of a vector contains all products of its entries.
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
        // Linear operations do not count: other units need more of them, and must round the same
        // way.
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

    /// Returns the two factors of a product.
    fn factors(&self, step: Step) -> Option<[Step; 2]> {
        match self.operation(step) {
            Operation::Binary(Arithmetic::Mul, a, b) => Some(sorted(a, b)),
            Operation::Of(Function::Sqr, a) => Some([a, a]),
            _ => None,
        }
    }

    /// Returns the steps with squares on the diagonal, and the steps that they are multiplied by
    /// elsewhere. Returns `None` if a product may belong to two different pairs.
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

    /// Returns the number of nonlinear steps that these steps depend on.
    fn count_behind(&self, roots: &[Step]) -> usize {
        let is_needed = needed(self.operations(), roots, |step| self.value(step).is_none());
        let counts = |operation: Operation| {
            let is_leaf = matches!(operation, Operation::Coordinate(_) | Operation::Constant(_));
            !is_leaf && !is_linear(operation)
        };
        let steps = self.operations().iter().zip(is_needed);
        steps.filter(|&(&operation, is_needed)| is_needed && counts(operation)).count()
    }
}

impl Squares {
    /// Splits the vectors with these entries into functions and forms.
    fn combine(&mut self, combinations: &[Vec<Linear>], dimension: usize) {
        let terms = || combinations.iter().flatten().flat_map(|linear| &linear.terms);
        self.functions = terms().map(|&(step, _)| step).collect();
        self.functions.sort_unstable();
        self.functions.dedup();
        // The first form of each function. Other forms may be multiples of it.
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

/// Returns `f` such that `c = f g` up to rounding.
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
