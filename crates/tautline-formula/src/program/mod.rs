//! Programs: expressions as instructions over registers, of which each holds the numbers of many lanes.

mod allocation;
mod compiler;
mod instruction;
mod registers;
mod row;

pub(crate) use instruction::Instruction;
pub use registers::{InstructionSet, Registers, WIDTH};

/// The place of a register.
pub type Register = u32;

/// Instructions that fill registers with the values of some expressions.
///
/// The first registers are the coordinates, which stay as they are.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    instructions: Vec<Instruction>,
    /// How many registers there are.
    count: usize,
    /// What is in a register from the beginning on, and stays.
    constants: Vec<(Register, f64)>,
    /// Where the values are.
    pub(crate) outputs: Vec<Register>,
}

impl Program {
    /// Returns the number of instructions.
    pub(crate) fn len(&self) -> usize {
        self.instructions.len()
    }

    /// Returns the number of registers but for the values that were asked for.
    pub(crate) fn intermediates(&self) -> usize {
        let mut outputs = self.outputs.clone();
        outputs.sort_unstable();
        outputs.dedup();
        self.count - outputs.len()
    }

    /// Returns the number of registers.
    pub(crate) fn registers(&self) -> usize {
        self.count
    }
}
