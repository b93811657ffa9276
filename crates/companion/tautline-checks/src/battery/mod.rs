//! Named checks that run against the library or against a mutant.
//!
//! Each check runs on a [`Subject`](tautline_statements::Subject). The tests of the workspace run
//! all of them on [`LIBRARY`](tautline_statements::LIBRARY). The table of mutants runs them on
//! deliberately wrong variants and shows which check kills which mutant.

mod cases;
mod examination;
mod harness;
mod ledger;
mod numerics;
mod paper;
mod sharper;
mod suite;

pub use examination::{Examination, Sight};
pub use harness::{Case, Check, Count, Failure, Given, Kind, Outcome, Scope, Tally, Trial};
pub use ledger::{Entry, ledger};
pub use suite::suite;
