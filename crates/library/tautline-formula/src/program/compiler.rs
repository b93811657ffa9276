//! The compiler, which turns a graph into a program.

use crate::{
    graph::Graph,
    operation::{Arithmetic, Function, Operation, Step, Tabulation},
    program::{
        Instruction, Program, Register,
        allocation::Allocation,
        sum::{Term, sum},
    },
};

/// The largest number of terms of one fused sum.
const MOST_TERMS: usize = 8;

/// A graph that is being compiled.
struct Compiler<'g> {
    graph: &'g Graph,
    /// How often each step is read. Being an output counts as two reads.
    uses: Vec<u32>,
}

impl Program {
    /// Compiles the expressions of these steps. The first `inputs` registers are the coordinates.
    /// Returns `None` if there are too many registers.
    pub(crate) fn new(graph: &Graph, inputs: usize, outputs: &[Step]) -> Option<Self> {
        let compiler = Compiler::new(graph, outputs);
        compiler.compile(inputs, outputs)
    }
}

impl<'g> Compiler<'g> {
    fn new(graph: &'g Graph, outputs: &[Step]) -> Self {
        let mut uses = vec![0_u32; graph.operations().len()];
        for &output in outputs {
            uses[output as usize] = 2;
        }
        for (step, operation) in graph.operations().iter().enumerate().rev() {
            if uses[step] > 0 {
                for read in operation.reads(step as Step).into_iter().flatten() {
                    uses[read as usize] = uses[read as usize].saturating_add(1);
                }
            }
        }
        Self { graph, uses }
    }

    /// Returns whether a step is read only once, so that it may be fused into its reader.
    fn is_part(&self, step: Step) -> bool {
        self.uses[step as usize] == 1
    }

    fn is_sum(&self, step: Step) -> bool {
        let operation = self.graph.operation(step);
        let is_sum = matches!(operation, Operation::Binary(Arithmetic::Add | Arithmetic::Sub, ..));
        is_sum && self.is_part(step)
    }

    fn product(&self, step: Step) -> Option<[Step; 2]> {
        match self.graph.operation(step) {
            Operation::Binary(Arithmetic::Mul, a, b) => Some([a, b]),
            Operation::Of(Function::Sqr, a) => Some([a, a]),
            _ => None,
        }
    }

    fn term(&self, step: Step, sign: f64) -> Term {
        let part = |step: Step| self.is_part(step).then_some(step);
        let Some(own) = part(step) else { return Term::Linear(sign, step) };
        if let Some(factors) = self.product(own) {
            return Term::Product(sign, factors);
        }
        match self.graph.operation(own) {
            Operation::WithNumber(Arithmetic::Mul, x, c) => {
                let c = sign * c.value();
                match part(x).and_then(|x| self.product(x)) {
                    Some(factors) => Term::Product(c, factors),
                    None => Term::Linear(c, x),
                }
            }
            Operation::Of(Function::Neg, x) => Term::Linear(-sign, x),
            _ => Term::Linear(sign, own),
        }
    }

    /// Returns the terms of a step in the order of addition, and no terms if the step is not a sum.
    ///
    /// `a + (b + c)` becomes `(b + c) + a`, but `(a + b) + (c + d)` keeps its second sum as a term.
    fn terms(&self, step: Step) -> Vec<Term> {
        let mut terms = Vec::new();
        let mut next = Some(step);
        while let Some(step) = next {
            let (a, b, sign) = match self.graph.operation(step) {
                Operation::Binary(Arithmetic::Add, a, b) if !self.is_sum(a) && self.is_sum(b) => {
                    (b, a, 1.0)
                }
                Operation::Binary(Arithmetic::Add, a, b) => (a, b, 1.0),
                Operation::Binary(Arithmetic::Sub, a, b) => (a, b, -1.0),
                _ => return terms,
            };
            terms.push(self.term(b, sign));
            // The rest is a separate sum, so that fewer terms are live at once.
            next = (terms.len() < MOST_TERMS && self.is_sum(a)).then_some(a);
            if next.is_none() {
                terms.push(self.term(a, 1.0));
            }
        }
        terms.reverse();
        terms
    }

    /// Returns the terms of a step, or none if it is one instruction, and the steps that it reads.
    fn unit(&self, step: Step) -> (Vec<Term>, Vec<Step>) {
        let operation = self.graph.operation(step);
        let mut terms = match operation {
            Operation::Binary(Arithmetic::Add | Arithmetic::Sub, ..) => self.terms(step),
            _ => Vec::new(),
        };
        if let Operation::WithNumber(Arithmetic::Mul, x, c) = operation
            && self.is_part(x)
            && let Some(factors) = self.product(x)
        {
            terms = vec![Term::Product(c.value(), factors)];
        }
        let mut reads = Vec::new();
        if let Some(x) = self.taken_from(operation) {
            reads.push(x);
        } else if terms.is_empty() {
            reads.extend(operation.reads(step).into_iter().flatten());
        }
        for term in &terms {
            match *term {
                Term::Linear(_, x) => reads.push(x),
                Term::Product(_, factors) => reads.extend(factors),
            }
        }
        (terms, reads)
    }

    /// Returns `x` if the operation is `c − x`.
    fn taken_from(&self, operation: Operation) -> Option<Step> {
        match operation {
            Operation::WithNumber(Arithmetic::Add, a, _) if self.is_part(a) => {
                match self.graph.operation(a) {
                    Operation::Of(Function::Neg, x) => Some(x),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Returns the steps to compute, each after the steps that it reads.
    fn order(&self, outputs: &[Step]) -> Vec<Step> {
        let mut is_open = vec![false; self.graph.operations().len()];
        let mut order = Vec::new();
        // Each step is visited twice: before and after the steps that it reads.
        let mut stack: Vec<(Step, bool)> =
            outputs.iter().rev().map(|&step| (step, false)).collect();
        while let Some((step, is_after)) = stack.pop() {
            if is_after {
                order.push(step);
                continue;
            }
            if std::mem::replace(&mut is_open[step as usize], true) {
                continue;
            }
            stack.push((step, true));
            let reads = self.unit(step).1;
            stack.extend(
                reads
                    .into_iter()
                    .rev()
                    .filter(|&read| !is_open[read as usize])
                    .map(|read| (read, false)),
            );
        }
        order
    }

    fn compile(&self, inputs: usize, outputs: &[Step]) -> Option<Program> {
        let order = self.order(outputs);
        let mut allocation =
            Allocation::new(self.graph.operations(), inputs, outputs, &order, |step| {
                self.unit(step).1
            });
        let mut program = Program {
            instructions: Vec::with_capacity(order.len()),
            count: inputs,
            constants: Vec::new(),
            tables: self.graph.tables().to_vec(),
            outputs: Vec::new(),
        };
        // Coordinates and constants keep their registers.
        for &step in &order {
            match self.graph.operation(step) {
                Operation::Coordinate(i) => {
                    allocation.place[step as usize] = Some(Register::try_from(i).ok()?)
                }
                Operation::Constant(c) => {
                    let register = allocation.fresh()?;
                    allocation.place[step as usize] = Some(register);
                    program.constants.push((register, c.value()));
                }
                _ => {}
            }
        }
        for (time, &step) in order.iter().enumerate() {
            if allocation.place[step as usize].is_none() {
                self.emit(step, time, &mut allocation, &mut program.instructions)?;
            } else {
                // This step is computed together with its sine or cosine.
                allocation.release(&self.unit(step).1, time);
            }
        }
        program.outputs = outputs
            .iter()
            .map(|&output| allocation.place[output as usize])
            .collect::<Option<_>>()?;
        program.count = allocation.count;
        Some(program)
    }

    fn emit(
        &self,
        step: Step,
        time: usize,
        allocation: &mut Allocation,
        instructions: &mut Vec<Instruction>,
    ) -> Option<()> {
        let (terms, reads) = self.unit(step);
        let operation = self.graph.operation(step);
        // Results are made in a spare row, so they may take the register of an operand.
        allocation.release(&reads, time);
        let to = allocation.take()?;
        let wave = match operation {
            Operation::Of(Function::Sin, a) => Some((Operation::Of(Function::Cos, a), true)),
            Operation::Of(Function::Cos, a) => Some((Operation::Of(Function::Sin, a), false)),
            _ => None,
        };
        let pair = match wave {
            Some((other, is_sine)) => {
                let beside = allocation.take()?;
                match allocation.waits(other) {
                    Some(partner) => allocation.place[partner as usize] = Some(beside),
                    None => allocation.free.push(beside),
                }
                Some(if is_sine { [to, beside] } else { [beside, to] })
            }
            None => None,
        };
        // The operands are still in their registers at this point.
        let place = &allocation.place;
        let at = |step: Step| place[step as usize].unwrap_or_default();
        if terms.is_empty() {
            instructions.push(self.single(operation, to, pair, at)?);
        } else {
            sum(&terms, to, at, instructions);
        }
        allocation.place[step as usize] = Some(to);
        Some(())
    }

    /// Returns a step that is not a sum as one instruction.
    fn single(
        &self,
        operation: Operation,
        to: Register,
        pair: Option<[Register; 2]>,
        at: impl Fn(Step) -> Register,
    ) -> Option<Instruction> {
        Some(match operation {
            Operation::Binary(Arithmetic::Mul, a, b) => Instruction::Mul(to, [at(a), at(b)]),
            Operation::Binary(Arithmetic::Div, a, b) => Instruction::Div(to, [at(a), at(b)]),
            Operation::WithNumber(Arithmetic::Add, a, c) => match self.taken_from(operation) {
                Some(x) => Instruction::From(to, at(x), c.value()),
                None => Instruction::Plus(to, at(a), c.value()),
            },
            Operation::WithNumber(Arithmetic::Mul, a, c) => {
                Instruction::Times(to, at(a), c.value())
            }
            Operation::WithNumber(Arithmetic::Div, a, c) => Instruction::Over(to, at(a), c.value()),
            Operation::Of(function, a) => match pair {
                Some(pair) => Instruction::SinCos(pair, at(a)),
                None => Instruction::Of(function, to, at(a)),
            },
            Operation::Table(Tabulation { table, orders, axes, arguments }) => {
                Instruction::Table { to, table, orders, axes, u: arguments.map(at) }
            }
            // Sums have terms, coordinates and constants have registers, and a graph contains
            // nothing else.
            _ => return None,
        })
    }
}
