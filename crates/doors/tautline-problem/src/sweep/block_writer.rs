//! `BlockWriter`: the text of a block of results, part by part.

use std::ops::Range;

use super::{Head, Plan, PlanError, block::END, hash::Hash, result_row};

/// The text of a block of results, part by part, so that it need not fit into memory.
#[derive(Clone, Debug)]
pub struct BlockWriter {
    hash: Hash,
}

impl BlockWriter {
    /// Begins a block of a plan. Returns the first part of the text with the writer.
    ///
    /// # Errors
    ///
    /// [`PlanError::Ids`].
    pub fn of_plan(plan: &Plan, ids: Range<u64>) -> Result<(Self, String), PlanError> {
        plan.check(&ids)?;
        Ok(Self::new(&head(plan, ids)))
    }

    /// Begins a block. Returns the first part of the text with the writer.
    #[must_use]
    pub fn new(head: &Head) -> (Self, String) {
        let (text, mut hash) = (head.text(), Hash::default());
        hash.add(&text);
        (Self { hash }, text)
    }

    /// Returns rows as the next part of the text.
    pub fn rows(&mut self, rows: String) -> String {
        self.hash.add(&rows);
        rows
    }

    /// Returns the last part of the text, which says that the block is complete.
    #[must_use]
    pub fn end(self) -> String {
        format!("{END}{}\n", self.hash.digits())
    }
}

/// Returns the head of a block of a plan.
fn head(plan: &Plan, ids: Range<u64>) -> Head {
    Head {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        plan: plan.hash().to_owned(),
        count: plan.count(),
        ids,
        columns: format!("{},{}", plan.columns(), result_row::COLUMNS.join(",")),
    }
}

impl Plan {
    /// Returns whether a block is that of these ids of this plan, computed by this version.
    #[must_use]
    pub fn has(&self, block: &Head, ids: Range<u64>) -> bool {
        *block == head(self, ids)
    }
}
