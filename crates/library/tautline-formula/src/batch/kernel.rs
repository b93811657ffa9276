//! `Kernel`: the program that fills the rows of a batch.

use crate::{
    batch::{CHUNKED, Kind, Layout},
    formula::Tape,
    graph::{Contracted, Order, Sums, contract},
    operation::Step,
    program::{Program, Register, WIDTH},
};

/// How many numbers fit into a first-level cache, with a margin.
///
/// A program whose intermediate results do not fit, even in the fewest lanes, is not used. The
/// limit comes from measurements on decoders with 4 to 64 hidden units, 8 to 784 outputs and 2 to 8
/// coordinates, with programs computed from the entries of `H`. Up to 300 intermediate registers, a
/// program takes 0.5 to 0.9 times as long as the compiled formula; with 400 and more, it takes 1.0
/// to 2.6 times as long.
///
/// From 24 coordinates on, a program of any length is worth it, because the compiled formula is
/// evaluated anew for every few directions. For sums of 4 to 32 matrices of rank one on 24, 32 and
/// 64 coordinates, with 340 to 2200 intermediate registers, a program takes 0.001 to 0.005 times as
/// long.
const NUMBERS_IN_CACHE: usize = 3072;

/// The same limit for derivatives computed from squares of vectors.
///
/// They have as many registers as a Jacobian has entries, but few instructions. The measured
/// decoders have 16 to 64 hidden units, 16 to 100 outputs and 2 to 16 coordinates. Their programs
/// have 400 to 1800 registers, far more than fit into a first-level cache. Even so, a program for
/// `H` and all derivatives takes 0.004 to 0.52 times as long as the compiled formula, and a program
/// for the first derivatives 0.13 to 0.56 times as long.
const NUMBERS_BY_SQUARES: usize = 16384;

/// A program and the layout of its results.
#[derive(Debug)]
pub(crate) struct Kernel {
    program: Program,
    layout: Layout,
}

impl Kernel {
    /// Derives the program of a kind. Returns `None` if the compiled formula is faster.
    pub(crate) fn new(formula: Tape<'_>, kind: Kind) -> Option<Self> {
        let order = match kind {
            Kind::Square | Kind::Checked => Order::Zero,
            Kind::Momentum => Order::First,
            Kind::Contraction => Order::Second,
        };
        let contracted = contract(formula, order, kind != Kind::Square)?;
        let Contracted { graph, gram, sums, .. } = &contracted;
        let Sums { square, momentum, slope, turn, bend } = sums;
        let mut steps: Vec<Step> = Vec::new();
        match kind {
            Kind::Square | Kind::Checked => steps.push(*square),
            Kind::Momentum => {
                steps.push(*square);
                steps.extend(momentum.iter().chain(slope));
            }
            Kind::Contraction => steps.extend(gram.iter().chain(slope).chain(turn).chain(bend)),
        }
        if kind != Kind::Square {
            steps.extend(&contracted.pivots);
            steps.extend(contracted.halves.iter().flat_map(|half| half.entries));
            steps.extend(contracted.halves.iter().flat_map(|half| half.diagonal));
        }
        let program = Program::new(graph, 2 * formula.dimension, &steps)?;
        let most = match order {
            Order::First | Order::Second if contracted.is_by_squares => NUMBERS_BY_SQUARES,
            _ => NUMBERS_IN_CACHE,
        };
        if formula.dimension < CHUNKED && WIDTH * program.intermediates() > most {
            return None;
        }
        let layout = Reader(&program.outputs).layout(&contracted, kind, formula.dimension);
        Some(Self { program, layout })
    }

    pub(crate) fn program(&self) -> &Program {
        &self.program
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Returns how many lanes keep all registers in a cache.
    pub(crate) fn lanes(&self) -> usize {
        (NUMBERS_IN_CACHE / self.program.registers()).next_power_of_two().max(WIDTH)
    }

    /// Returns the number of instructions and the number of registers.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.program.len(), self.program.registers()]
    }
}

/// Hands out the output registers in the order of their steps.
struct Reader<'p>(&'p [Register]);

impl Reader<'_> {
    fn take(&mut self, count: usize) -> Vec<Register> {
        let (taken, rest) = self.0.split_at(count);
        self.0 = rest;
        taken.to_vec()
    }

    /// Reads a symmetric matrix, which is stored as its entries `i ≤ j`.
    fn symmetric(&mut self, dimension: usize) -> Vec<Register> {
        let upper = self.take(dimension * (dimension + 1) / 2);
        let place = |i: usize, j: usize| i * dimension - i * (i + 1) / 2 + j;
        let entry = |n: usize| {
            let (i, j) = (n / dimension, n % dimension);
            upper[place(i.min(j), i.max(j))]
        };
        (0..dimension * dimension).map(entry).collect()
    }

    fn layout(mut self, contracted: &Contracted, kind: Kind, dimension: usize) -> Layout {
        let mut layout = Layout::default();
        match kind {
            Kind::Square => {
                layout.square = self.take(1);
                return layout;
            }
            Kind::Checked => layout.square = self.take(1),
            Kind::Momentum => {
                layout.square = self.take(1);
                layout.momentum = self.take(dimension);
                layout.slope = self.take(dimension);
            }
            Kind::Contraction => {
                layout.gram = self.symmetric(dimension);
                layout.slope = self.take(dimension);
                layout.turn = self.take(dimension * dimension);
                layout.bend = self.symmetric(dimension);
            }
        }
        layout.positive = self.take(contracted.pivots.len());
        let halves = 2 * contracted.halves.len();
        let (entries, diagonal) = (self.take(halves), self.take(halves));
        let pairs = entries.chunks_exact(2).zip(diagonal.chunks_exact(2));
        layout.halves = pairs.map(|(a, b)| [a[0], a[1], b[0], b[1]]).collect();
        layout
    }
}
