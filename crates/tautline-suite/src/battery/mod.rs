//! The project's own suite: named checks that run against the library or a wrong variant of it.
//!
//! A check is run on a [`Subject`](tautline_statements::Subject). The tests of the workspace run all of them on
//! [`LIBRARY`](tautline_statements::LIBRARY); the table of mutants runs on deliberately wrong variants those that can
//! see what is wrong, and shows which check kills which.

mod admissible;
mod any_strategy;
mod check;
mod close;
mod dropped;
mod examination;
mod existence;
mod failing;
mod fingerprint;
mod global_minima;
mod golden;
mod gradients;
mod leading_constants;
mod ledger;
mod orders;
mod point_sequences;
mod promotion;
mod proved_numbers;
mod quick;
mod random_problems;
mod section_1;
mod section_3;
mod section_4;
mod section_5;
mod section_6;
mod section_7_algebra;
mod section_7_apriori;
mod section_7_morrey;
mod section_7_sampling;
mod section_9;
mod sharper;
mod sheared;
mod slope;
mod tally;
mod theorem_witnesses;
mod trial;

pub use check::{Check, Kind};
pub use examination::{Examination, Sight};
pub use ledger::{Entry, ledger};
pub use promotion::{Case, Given};
pub use tally::{Count, Tally};
pub use trial::{Failure, Outcome, Scope, Trial};

/// Returns all checks, in the paper's order.
#[must_use]
pub fn suite() -> Vec<Check> {
    let sections = [
        section_1::checks(),
        theorem_witnesses::checks(),
        orders::checks(),
        leading_constants::checks(),
        golden::checks(),
        gradients::checks(),
        section_3::checks(),
        section_4::checks(),
        section_5::checks(),
        global_minima::checks(),
        section_6::checks(),
        existence::checks(),
        section_7_morrey::checks(),
        section_7_algebra::checks(),
        section_7_sampling::checks(),
        section_7_apriori::checks(),
        point_sequences::checks(),
        proved_numbers::checks(),
        section_9::checks(),
        dropped::checks(),
        sharper::checks(),
    ];
    sections.into_iter().flatten().collect()
}
