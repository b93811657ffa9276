//! Programs: expressions compiled to instructions on registers of many lanes.

mod allocation;
mod compiler;
mod instruction;
mod registers;
mod row;
mod sum;

use std::sync::Arc;

use tautline_scalar::Table;

pub(crate) use instruction::Instruction;
pub use registers::{InstructionSet, Registers, WIDTH};

/// The index of a register.
pub type Register = u32;

/// Instructions that fill registers with the values of some expressions.
///
/// The first registers are the coordinates and are never overwritten.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    instructions: Vec<Instruction>,
    /// The number of registers.
    count: usize,
    /// The registers with constant values, and these values.
    constants: Vec<(Register, f64)>,
    /// The tables that instructions refer to.
    tables: Vec<Arc<dyn Table>>,
    /// The registers of the values.
    pub(crate) outputs: Vec<Register>,
}

impl Program {
    pub(crate) fn len(&self) -> usize {
        self.instructions.len()
    }

    /// The number of registers that are not outputs.
    pub(crate) fn intermediates(&self) -> usize {
        let mut outputs = self.outputs.clone();
        outputs.sort_unstable();
        outputs.dedup();
        self.count - outputs.len()
    }

    pub(crate) fn registers(&self) -> usize {
        self.count
    }
}
