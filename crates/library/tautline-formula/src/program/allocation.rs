//! `Allocation`: the register of each step.

use std::collections::HashMap;

use crate::{
    operation::{Function, Operation, Step},
    program::Register,
};

/// The register of each step.
pub(super) struct Allocation {
    pub(super) place: Vec<Option<Register>>,
    /// The time at which a step is last read, or `usize::MAX` if its register is never freed.
    last: Vec<usize>,
    pub(super) free: Vec<Register>,
    pub(super) count: usize,
    /// The sines and cosines that are to be computed.
    waves: HashMap<Operation, Step>,
}

impl Allocation {
    /// Allocates registers for steps in this order, given what each reads. The first registers are
    /// the inputs.
    pub(super) fn new(
        operations: &[Operation],
        inputs: usize,
        outputs: &[Step],
        order: &[Step],
        reads: impl Fn(Step) -> Vec<Step>,
    ) -> Self {
        let mut last = vec![usize::MAX; operations.len()];
        let mut waves = HashMap::new();
        for (time, &step) in order.iter().enumerate() {
            for read in reads(step) {
                last[read as usize] = time;
            }
            if let operation @ Operation::Of(Function::Sin | Function::Cos, _) =
                operations[step as usize]
            {
                waves.insert(operation, step);
            }
        }
        for (step, operation) in operations.iter().enumerate() {
            if matches!(operation, Operation::Coordinate(_) | Operation::Constant(_)) {
                last[step] = usize::MAX;
            }
        }
        for &output in outputs {
            last[output as usize] = usize::MAX;
        }
        Self { place: vec![None; operations.len()], last, free: Vec::new(), count: inputs, waves }
    }

    pub(super) fn fresh(&mut self) -> Option<Register> {
        let register = Register::try_from(self.count).ok()?;
        self.count += 1;
        Some(register)
    }

    pub(super) fn take(&mut self) -> Option<Register> {
        self.free.pop().or_else(|| self.fresh())
    }

    /// Frees the registers that are read here for the last time.
    pub(super) fn release(&mut self, reads: &[Step], time: usize) {
        let mut dying: Vec<Step> =
            reads.iter().copied().filter(|&read| self.last[read as usize] == time).collect();
        dying.sort_unstable();
        dying.dedup();
        self.free.extend(dying.into_iter().filter_map(|read| self.place[read as usize]));
    }

    /// Returns the step of a wave that is needed and has no register yet.
    pub(super) fn waits(&self, wave: Operation) -> Option<Step> {
        self.waves.get(&wave).copied().filter(|&step| self.place[step as usize].is_none())
    }
}
