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

/// The largest number of operations that are derived for a formula that is compiled too. They take about a tenth
/// of a second.
const MOST_OF_COMPILED: usize = 1 << 18;

/// The same for a formula that is not, in two seconds.
const MOST: usize = 1 << 22;

/// A program and the layout of its results.
#[derive(Debug)]
pub(crate) struct Kernel {
    program: Program,
    layout: Layout,
}

impl Kernel {
    /// Derives the program of a kind. Returns `None` if it becomes too long, or if the formula is compiled and
    /// faster. Step by step a formula is never faster: at 42 outputs of a decoder with 32 hidden units on 8
    /// coordinates, a hundred times as slow.
    pub(crate) fn new(formula: Tape<'_>, kind: Kind, is_compiled: bool) -> Option<Self> {
        let order = match kind {
            Kind::Square | Kind::Checked => Order::Zero,
            Kind::Momentum => Order::First,
            Kind::Contraction => Order::Second,
        };
        let most = if is_compiled { MOST_OF_COMPILED } else { MOST };
        let contracted = contract(formula, order, kind != Kind::Square, most)?;
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
        let is_slow = WIDTH * program.intermediates() > most;
        if is_compiled && formula.dimension < CHUNKED && is_slow {
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
