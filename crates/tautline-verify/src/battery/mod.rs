//! The project's own suite: named checks, to which the library and any variant of it can be put.
//!
//! A check is generic over its [`Subject`]. The tests of the workspace run all
//! of them on [`Library`](crate::Library); the table of mutants runs them on deliberately wrong
//! variants, and shows which check kills which.

mod check;
mod ledger;
mod point_sequences;
mod section_1;
mod tally;
mod trial;

pub use check::{Check, Kind};
pub use ledger::{Entry, kills, ledger};
pub use tally::{Count, Tally};
pub use trial::{Failure, Outcome, Scope, Trial};

use crate::Subject;

/// Returns all checks, in the paper's order.
#[must_use]
pub fn battery<S: Subject>() -> Vec<Check<S>> {
    [section_1::checks(), point_sequences::checks()].into_iter().flatten().collect()
}
