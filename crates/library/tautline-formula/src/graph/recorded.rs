//! The graph of a recorded formula.

use std::collections::HashMap;

use crate::{
    formula::Tape,
    graph::{Graph, Identities},
    operation::{Arithmetic, Operation, Step, Tabulation, function_at},
};

impl Graph {
    /// Returns the graph of a formula, with room for so many operations, and its entries `(i, j)` at `[i D + j]`.
    pub(crate) fn of(formula: Tape<'_>, most: usize) -> (Self, Vec<Step>) {
        let mut graph = Self {
            tables: formula.tables.to_vec(),
            operations: Vec::new(),
            known: HashMap::new(),
            identities: Identities::Exact,
            most,
            is_full: false,
        };
        let mut made: Vec<Step> = Vec::with_capacity(formula.operations.len());
        for (place, &operation) in formula.operations.iter().enumerate() {
            let at = |step: Step| made[step as usize];
            let step = match operation {
                Operation::Coordinate(_) => graph.node(operation),
                Operation::Constant(number) => graph.constant(number.value()),
                Operation::Binary(Arithmetic::Add, a, b) => graph.add(at(a), at(b)),
                Operation::Binary(Arithmetic::Sub, a, b) => graph.sub(at(a), at(b)),
                Operation::Binary(Arithmetic::Mul, a, b) => graph.mul(at(a), at(b)),
                Operation::Binary(Arithmetic::Div, a, b) => graph.div(at(a), at(b)),
                Operation::WithNumber(Arithmetic::Add, a, c) => graph.plus(at(a), c.value()),
                Operation::WithNumber(Arithmetic::Sub, a, c) => graph.plus(at(a), -c.value()),
                Operation::WithNumber(Arithmetic::Mul, a, c) => graph.times(at(a), c.value()),
                Operation::WithNumber(Arithmetic::Div, a, c) => graph.over(at(a), c.value()),
                Operation::Powi(a, n) => graph.power(at(a), n),
                Operation::Table(call) => {
                    graph.table(Tabulation { arguments: call.arguments.map(at), ..call })
                }
                Operation::Of(..) | Operation::First(..) | Operation::Second => {
                    let (function, a) =
                        function_at(formula.operations, place).expect("a second follows its first");
                    graph.apply(function, at(a))
                }
            };
            made.push(step);
        }
        let d = formula.dimension;
        let entry = |place: usize| made[formula.entries[place % d * d + place / d] as usize];
        (graph, (0..d * d).map(entry).collect())
    }
}
