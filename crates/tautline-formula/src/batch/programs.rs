//! `Programs`: a formula by batches.

use std::sync::OnceLock;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{
    Formula,
    batch::{Batches, Kind, Layout},
    graph::{Contracted, Order, contract},
    program::{InstructionSet, Program, Register, Registers},
};

/// So many numbers are in a cache of the first level, with something left.
const NUMBERS_IN_CACHE: usize = 3072;

/// The greatest number of lanes.
const LANES: usize = 64;

/// The programs of a formula, each derived when it is needed for the first time.
#[derive(Debug)]
pub struct Programs<const D: usize> {
    formula: Formula<D>,
    instruction_set: InstructionSet,
    lanes: usize,
    kinds: [OnceLock<Kernel>; 3],
}

impl<const D: usize> Programs<D> {
    /// The programs of a formula, with the widest instructions that there are.
    #[must_use]
    pub fn new(formula: Formula<D>) -> Self {
        Self::with(formula, InstructionSet::Widest, LANES)
    }

    /// The programs of a formula for at most so many lanes. The results are the same to the bit.
    #[must_use]
    pub fn with(formula: Formula<D>, instruction_set: InstructionSet, lanes: usize) -> Self {
        Self { formula, instruction_set, lanes, kinds: Default::default() }
    }

    /// Returns the formula.
    #[must_use]
    pub fn formula(&self) -> &Formula<D> {
        &self.formula
    }

    fn kernel(&self, kind: Kind) -> &Kernel {
        let place = &self.kinds[kind as usize];
        place.get_or_init(|| Kernel::new(&self.formula, kind, self.lanes))
    }

    /// Returns the number of instructions and of registers of a program.
    #[must_use]
    pub fn size(&self, kind: Kind) -> [usize; 2] {
        let program = &self.kernel(kind).program;
        [program.len(), program.registers()]
    }
}

impl<const D: usize> Batches<D> for Programs<D> {
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        Metric::gram(&self.formula, x)
    }

    fn layout(&self, kind: Kind) -> &Layout {
        &self.kernel(kind).layout
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        let Kernel { program, lanes, .. } = self.kernel(kind);
        let lanes = unit.saturating_mul(units).clamp(unit, unit.max(*lanes));
        Registers::new(program, lanes, self.instruction_set)
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        registers.run(&self.kernel(kind).program);
    }
}

/// A program and where its results are.
#[derive(Debug)]
struct Kernel {
    program: Program,
    layout: Layout,
    lanes: usize,
}

impl Kernel {
    fn new<const D: usize>(
        formula: &Formula<D>,
        kind: Kind,
        lanes: usize,
    ) -> Self {
        let order = if kind == Kind::Contraction { Order::Second } else { Order::First };
        let contracted = contract(formula, order);
        let Contracted { graph, square, momentum, .. } = &contracted;
        let compile = |outputs: &Outputs| Program::new(graph, 2 * D, &outputs.steps);
        let shorter = |one: &Outputs, other: &Outputs| {
            let [a, b] = [one, other].map(|outputs| compile(outputs).expect("few registers"));
            if a.len() <= b.len() { a } else { b }
        };
        let mut outputs = Outputs::default();
        let program = match kind {
            Kind::Square => {
                let [one, other] = square.map(|square| {
                    let mut outputs = Outputs::default();
                    outputs.add(&[square]);
                    outputs
                });
                outputs = one.clone();
                shorter(&one, &other)
            }
            Kind::Momentum => {
                let of = |place: usize| {
                    let mut outputs = Outputs::default();
                    outputs.add(&[square[place]]);
                    outputs.add(&momentum[place]);
                    outputs.add(&contracted.slope);
                    outputs.add_metric(&contracted);
                    outputs
                };
                let [one, other] = [of(0), of(1)];
                outputs = one.clone();
                shorter(&one, &other)
            }
            Kind::Contraction => {
                outputs.add(&contracted.gram);
                outputs.add(&contracted.slope);
                outputs.add(&contracted.turn);
                outputs.add(&contracted.bend);
                outputs.add_metric(&contracted);
                compile(&outputs).expect("few registers")
            }
        };
        let layout = layout(kind, D, &program.outputs, &contracted);
        let fit = (NUMBERS_IN_CACHE / program.registers()).next_power_of_two();
        Self { program, layout, lanes: lanes.min(fit.max(crate::WIDTH)) }
    }
}

#[derive(Clone, Debug, Default)]
struct Outputs {
    steps: Vec<crate::Step>,
}
impl Outputs {
    fn add(&mut self, steps: &[crate::Step]) {
        self.steps.extend(steps);
    }
    fn add_metric(&mut self, contracted: &Contracted) {
        self.add(&contracted.pivots);
        for (_, _, steps) in &contracted.halves {
            self.add(steps);
        }
        if !contracted.halves.is_empty() {
            self.add(&contracted.diagonal());
        }
    }
}

fn layout(kind: Kind, dimension: usize, outputs: &[Register], contracted: &Contracted) -> Layout {
    let mut rest = outputs;
    let mut take = |count: usize| {
        let (taken, left) = rest.split_at(count);
        rest = left;
        taken.to_vec()
    };
    let square = |upper: &[Register]| -> Vec<Register> {
        let place = |i: usize, j: usize| {
            let (i, j) = (i.min(j), i.max(j));
            i * dimension - i * (i + 1) / 2 + j
        };
        (0..dimension * dimension).map(|n| upper[place(n / dimension, n % dimension)]).collect()
    };
    let upper = dimension * (dimension + 1) / 2;
    let mut layout = Layout::default();
    match kind {
        Kind::Square => {
            layout.square = take(1);
            return layout;
        }
        Kind::Momentum => {
            layout.square = take(1);
            layout.momentum = take(dimension);
            layout.slope = take(dimension);
        }
        Kind::Contraction => {
            layout.gram = square(&take(upper));
            layout.slope = take(dimension);
            layout.turn = take(dimension * dimension);
            layout.bend = square(&take(upper));
        }
    }
    layout.positive = take(contracted.pivots.len());
    let halves: Vec<Register> = take(2 * contracted.halves.len());
    let diagonal = rest;
    for ((i, j, _), half) in contracted.halves.iter().zip(halves.chunks_exact(2)) {
        layout.halves.push([half[0], half[1], diagonal[*i], diagonal[*j]]);
    }
    layout
}
