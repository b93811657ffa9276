//! The Gram matrix and its derivatives, contracted with a chord `d`.
//!
//! Let `H = C₀ + Σₘ bₘ(x) Cₘ` with constant matrices, and let `sₘ = dᵀCₘd` and `vₘ = Cₘd`. Then
//!
//! ```text
//! Gₖ = dᵀ ∂ₖH d = Σₘ sₘ ∂ₖbₘ,   Pᵢₖ = (∂ₖH d)ᵢ = Σₘ (vₘ)ᵢ ∂ₖbₘ,   Qₖₗ = dᵀ ∂ₖ∂ₗH d = Σₘ sₘ ∂ₖ∂ₗbₘ.
//! ```
//!
//! Only the `bₘ` are differentiated. If `Cₘ = ± a aᵀ`, then `vₘ = ± a (aᵀd)` and `sₘ = ± (aᵀd)²`.
//! Squares of vectors `a(x)` may be split off from this sum.

use crate::{
    formula::Tape,
    graph::{Graph, derivative::Order, linear::Linear},
    operation::{Function, Step},
};

/// The contraction of a formula with a chord.
#[derive(Debug)]
pub(crate) struct Contracted {
    pub(crate) graph: Graph,
    /// The entries `i ≤ j` of `H`, row by row.
    pub(crate) gram: Vec<Step>,
    /// The entries for which the formula does not compute both halves of `H` by the same step.
    pub(crate) halves: Vec<Half>,
    /// Numbers that are all positive and finite where `H` is positive definite and finite.
    pub(crate) pivots: Vec<Step>,
    pub(crate) sums: Sums,
    /// Whether squares of vectors are contracted separately.
    pub(crate) is_by_squares: bool,
}

/// Sums that are contracted with the chord.
#[derive(Debug)]
pub(crate) struct Sums {
    /// `dᵀHd`.
    pub(crate) square: Step,
    /// `Hd`.
    pub(crate) momentum: Vec<Step>,
    /// `G`.
    pub(crate) slope: Vec<Step>,
    /// `P`, row by row.
    pub(crate) turn: Vec<Step>,
    /// The entries `k ≤ l` of `Q`, row by row.
    pub(crate) bend: Vec<Step>,
}

/// Two mirrored entries that must have the same value, together with the diagonal entries of their
/// rows.
#[derive(Debug)]
pub(crate) struct Half {
    /// `(i, j)` and `(j, i)`.
    pub(crate) entries: [Step; 2],
    /// `(i, i)` and `(j, j)`.
    pub(crate) diagonal: [Step; 2],
}

/// Contracts a formula and its derivatives up to this order with a chord. Returns `None` if that
/// takes more than `most` operations.
///
/// If `needs_gram` is set, the entries of `H` are computed anyway. If, in addition, only `dᵀHd` is
/// wanted, it is cheaper to compute it from these entries than from squares of vectors.
pub(crate) fn contract(
    formula: Tape<'_>,
    order: Order,
    needs_gram: bool,
    most: usize,
) -> Option<Contracted> {
    let dimension = formula.dimension;
    let (mut graph, entries) = Graph::of(formula, most);
    if graph.is_full() {
        return None;
    }
    let upper = || (0..dimension).flat_map(|i| (i..dimension).map(move |j| (i, j)));
    let at = |i: usize, j: usize| entries[i * dimension + j];
    let gram: Vec<Step> = upper().map(|(i, j)| at(i, j)).collect();
    let halves = upper()
        .filter(|&(i, j)| at(i, j) != at(j, i))
        .map(|(i, j)| Half { entries: [at(i, j), at(j, i)], diagonal: [at(i, i), at(j, j)] })
        .collect();
    let pivots = graph.pivots(dimension, |i, j| at(i.min(j), i.max(j)));
    // Of a full matrix in about ninety dimensions. What follows has a matrix for each base.
    if graph.is_full() {
        return None;
    }
    let own = own_entries(&graph, &gram);
    let mut split = split(&graph, &gram, &own, dimension);
    let squares = if needs_gram && order == Order::Zero {
        None
    } else {
        graph.squares(&gram, dimension, &bases(&split.1))
    };
    if let Some((rest, _)) = &squares {
        split = by_bases(rest, dimension);
    }
    let (constant, parts) = split;
    graph.be_free();
    let d: Vec<Step> = (0..dimension).map(|i| graph.coordinate(dimension + i)).collect();
    let bases = bases(&parts);
    let functions = squares.iter().flat_map(|(_, squares)| &squares.functions);
    let differentiated: Vec<Step> = bases.iter().chain(functions).copied().collect();
    let derivatives = graph.derivatives(&differentiated, dimension, order);
    let (derivatives, of_functions) = derivatives.split_at(bases.len());
    let momenta: Vec<Momentum> =
        parts.iter().map(|part| graph.momentum(&part.matrix, &d)).collect();
    let first = |k: usize| derivatives.iter().map(move |of| of.first(k));
    let along: Vec<Step> = momenta.iter().map(|momentum| momentum.square).collect();
    let slope: Vec<Step> = (0..dimension).map(|k| graph.weighted(&along, first(k))).collect();
    let (mut turn, mut bend) = (Vec::new(), Vec::new());
    if order == Order::Second {
        for i in 0..dimension {
            let along: Vec<Step> = momenta.iter().map(|momentum| momentum.vector[i]).collect();
            turn.extend((0..dimension).map(|k| graph.weighted(&along, first(k))));
        }
        for place in upper() {
            let second = derivatives.iter().map(|of| of.second(place));
            bend.push(graph.weighted(&along, second));
        }
    }
    // The parts are used unless they outnumber the entries. The number of operations cannot be the
    // criterion: other units need a few more operations, and must round the same way.
    let Momentum { vector: momentum, square } = if squares.is_some() || parts.len() <= own.len() {
        let rest = graph.momentum(&constant, &d);
        graph.sum_of_parts(rest, &bases, &momenta)
    } else {
        let matrix: Vec<Step> = (0..dimension * dimension)
            .map(|n| gram_at(&gram, dimension, n / dimension, n % dimension))
            .collect();
        graph.matrix_times(&matrix, &d)
    };
    let mut sums = Sums { square, momentum, slope, turn, bend };
    if let Some((_, squares)) = &squares {
        graph.add_squares(squares, of_functions, order, &d, &mut sums);
    }
    let is_by_squares = squares.is_some();
    let whole = Contracted { graph, gram, halves, pivots, sums, is_by_squares };
    (!whole.graph.is_full()).then_some(whole)
}

/// Returns the entry `(i, j)` of a symmetric matrix with these entries `i ≤ j`, given row by row.
fn gram_at(gram: &[Step], dimension: usize, i: usize, j: usize) -> Step {
    let (i, j) = (i.min(j), i.max(j));
    gram[i * dimension - i * (i + 1) / 2 + j]
}

/// One function `bₘ` with its matrix, given row by row.
#[derive(Debug)]
struct Part {
    base: Step,
    matrix: Vec<f64>,
}

/// Returns the entries that are not constant, each once.
fn own_entries(graph: &Graph, gram: &[Step]) -> Vec<Step> {
    let mut own: Vec<Step> =
        gram.iter().copied().filter(|&entry| graph.value(entry).is_none()).collect();
    own.sort_unstable();
    own.dedup();
    own
}

/// Returns `C₀` and the parts of `H`. The parts come from the terms of the entries `i ≤ j`, or they
/// are the entries themselves if these are fewer.
fn split(graph: &Graph, gram: &[Step], own: &[Step], dimension: usize) -> (Vec<f64>, Vec<Part>) {
    let (constant, parts) = by_bases(&graph.linear(gram), dimension);
    if parts.len() <= own.len() {
        return (constant, parts);
    }
    let by_itself = |&entry: &Step| match graph.value(entry) {
        Some(constant) => Linear { constant, ..Linear::default() },
        None => Linear::step(entry),
    };
    let entries: Vec<Linear> = gram.iter().map(by_itself).collect();
    by_bases(&entries, dimension)
}

/// Returns `C₀` and the parts of a matrix with these entries `i ≤ j`.
fn by_bases(entries: &[Linear], dimension: usize) -> (Vec<f64>, Vec<Part>) {
    let mut bases: Vec<Step> =
        entries.iter().flat_map(|linear| linear.terms.iter().map(|term| term.0)).collect();
    bases.sort_unstable();
    bases.dedup();
    let matrix = || vec![0.0; dimension * dimension];
    let mut constant = matrix();
    let mut parts: Vec<Part> = bases.iter().map(|&base| Part { base, matrix: matrix() }).collect();
    let upper = (0..dimension).flat_map(|i| (i..dimension).map(move |j| (i, j)));
    for ((i, j), linear) in upper.zip(entries) {
        for place in [i * dimension + j, j * dimension + i] {
            constant[place] = linear.constant;
            for &(base, factor) in &linear.terms {
                if let Ok(part) = bases.binary_search(&base) {
                    parts[part].matrix[place] = factor;
                }
            }
        }
    }
    (constant, parts)
}

fn bases(parts: &[Part]) -> Vec<Step> {
    parts.iter().map(|part| part.base).collect()
}

/// The product of a matrix with `d`, and the product of `dᵀ` with this vector.
#[derive(Debug)]
struct Momentum {
    vector: Vec<Step>,
    square: Step,
}

impl Graph {
    /// Returns the sum of terms with factors; a term `None` is 0.
    pub(super) fn weighted(
        &mut self,
        factors: &[Step],
        terms: impl Iterator<Item = Option<Step>>,
    ) -> Step {
        let there = factors.iter().zip(terms).filter_map(|(&factor, term)| Some((factor, term?)));
        let products: Vec<Step> = there.map(|(factor, term)| self.mul(factor, term)).collect();
        self.sum(products)
    }

    /// Returns the sum of terms with constant factors.
    pub(super) fn combination(&mut self, terms: impl Iterator<Item = (Step, f64)>) -> Step {
        let products: Vec<Step> = terms.map(|(term, c)| self.times(term, c)).collect();
        self.sum(products)
    }

    /// Computes `Hd` and `dᵀHd` from the parts of `H`.
    fn sum_of_parts(&mut self, rest: Momentum, bases: &[Step], momenta: &[Momentum]) -> Momentum {
        let mut add = |rest: Step, of: &dyn Fn(&Momentum) -> Step| {
            let factors: Vec<Step> = momenta.iter().map(of).collect();
            let sum = self.weighted(&factors, bases.iter().copied().map(Some));
            self.add(rest, sum)
        };
        let vector = rest.vector.iter().enumerate();
        let vector = vector.map(|(i, &rest)| add(rest, &|of| of.vector[i])).collect();
        Momentum { vector, square: add(rest.square, &|of| of.square) }
    }

    /// Computes `Hd` and `dᵀHd` from the entries of `H`, given row by row.
    fn matrix_times(&mut self, matrix: &[Step], d: &[Step]) -> Momentum {
        let mut dot = |a: &[Step], b: &[Step]| self.weighted(a, b.iter().copied().map(Some));
        let vector: Vec<Step> = matrix.chunks_exact(d.len()).map(|row| dot(row, d)).collect();
        let square = dot(&vector, d);
        Momentum { vector, square }
    }

    /// Computes `Cd` and `dᵀCd`.
    fn momentum(&mut self, c: &[f64], d: &[Step]) -> Momentum {
        let dimension = d.len();
        if let Some((a, sign)) = rank_one(c, dimension) {
            let along = self.combination(d.iter().copied().zip(a.iter().copied()));
            let vector = a.iter().map(|&a| self.times(along, sign * a)).collect();
            let square = self.mul(along, along);
            return Momentum { vector, square: self.times(square, sign) };
        }
        let rows = c.chunks_exact(dimension).map(|row| d.iter().copied().zip(row.iter().copied()));
        let vector: Vec<Step> = rows.map(|terms| self.combination(terms)).collect();
        let terms: Vec<Step> = vector.iter().zip(d).map(|(&v, &d)| self.mul(v, d)).collect();
        Momentum { square: self.sum(terms), vector }
    }

    /// Returns the pivots of a symmetric matrix with these entries `i ≤ j`, each once.
    fn pivots(&mut self, dimension: usize, at: impl Fn(usize, usize) -> Step) -> Vec<Step> {
        let mut a: Vec<Step> =
            (0..dimension * dimension).map(|n| at(n / dimension, n % dimension)).collect();
        let mut pivots = Vec::new();
        for k in 0..dimension {
            let row: Vec<Step> = a[k * dimension..(k + 1) * dimension].to_vec();
            pivots.push(row[k]);
            let beside: Vec<usize> =
                (k + 1..dimension).filter(|&j| !self.is_zero(row[j])).collect();
            if beside.is_empty() {
                continue;
            }
            let reciprocal = self.apply(Function::Recip, row[k]);
            for (place, &i) in beside.iter().enumerate() {
                let factor = self.mul(row[i], reciprocal);
                for &j in &beside[place..] {
                    let eliminated = self.mul(factor, row[j]);
                    a[i * dimension + j] = self.sub(a[i * dimension + j], eliminated);
                }
            }
        }
        pivots.sort_unstable();
        pivots.dedup();
        pivots
    }
}

/// Returns `a` and `±1` such that `C = ± a aᵀ` up to rounding. It does so only in three dimensions
/// or more, where it saves operations.
fn rank_one(c: &[f64], dimension: usize) -> Option<(Vec<f64>, f64)> {
    let diagonal = |i: usize| c[i * dimension + i];
    let top = (0..dimension).max_by(|&i, &j| diagonal(i).abs().total_cmp(&diagonal(j).abs()))?;
    let pivot = diagonal(top);
    let scale = pivot.abs().sqrt();
    if dimension < 3 || !(pivot / scale).is_normal() {
        return None;
    }
    let row = &c[top * dimension..(top + 1) * dimension];
    let is_product = |n: usize| {
        let product = row[n / dimension] * (row[n % dimension] / pivot);
        (c[n] - product).abs() <= 4.0 * f64::EPSILON * c[n].abs()
    };
    (0..c.len())
        .all(is_product)
        .then(|| (row.iter().map(|&entry| entry / scale).collect(), pivot.signum()))
}
