//! The neck of an expression: a single step through which it depends on all its coordinates.

use crate::{
    graph::Graph,
    operation::{Arithmetic, Function, Operation, Step},
};

impl Graph {
    /// Returns the first step `u`, in the order of evaluation, with `root = F(u)` for a function
    /// `F` of one variable. Returns `None` if only the root itself qualifies.
    ///
    /// A mere multiple such as `x/2`, which is a coordinate in other units, does not count: it
    /// would round differently.
    pub(crate) fn neck(&self, root: Step) -> Option<Step> {
        let mut is_open = vec![false; root as usize + 1];
        is_open[root as usize] = true;
        // `open` counts the open steps that are not constants.
        let (mut open, mut neck) = (1, None);
        for step in (0..=root).rev() {
            if !is_open[step as usize] {
                continue;
            }
            let operation = self.operation(step);
            match operation {
                // If a coordinate occurs by itself, there is no neck before this point.
                Operation::Coordinate(_) => return neck,
                Operation::Constant(_) => continue,
                _ if open == 1 && step != root && !is_multiple(operation) => neck = Some(step),
                _ => {}
            }
            open -= 1;
            for read in operation.reads(step).into_iter().flatten() {
                if !std::mem::replace(&mut is_open[read as usize], true)
                    && self.value(read).is_none()
                {
                    open += 1;
                }
            }
        }
        neck
    }
}

/// Returns whether an operation is `c x` or `x/c`.
fn is_multiple(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::WithNumber(Arithmetic::Mul | Arithmetic::Div, ..)
            | Operation::Of(Function::Neg, _)
    )
}
