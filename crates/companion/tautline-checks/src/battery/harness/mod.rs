//! The code that runs a check: trials on random cases, verdicts, tallies, and failures written as
//! tests.

mod agreement;
mod any_value;
mod check;
mod failing;
mod failure;
mod fingerprint;
mod golden;
mod homogeneous;
mod promotion;
mod quick;
mod tally;
mod trial;

pub(crate) use agreement::{close, has_slope};
pub use check::{Check, Kind};
pub(crate) use check::{
    Kind::{Dropped, Homogeneous, Order, Proved, Random, Reference, Refuted, Witness},
    all, for_rules,
};
pub(crate) use failing::{fails_without, holds_without, refuted};
pub use failure::{Failure, Outcome};
pub(crate) use fingerprint::Fingerprint;
pub(crate) use golden::Golden;
pub use promotion::{Case, Given};
pub use tally::{Count, Tally};
pub(crate) use trial::for_all;
pub use trial::{Scope, Trial};

/// Returns evidence for Theorem 1.1 with two hypotheses, a conclusion and a companion. Each clause
/// holds if its number is at most 1.
#[cfg(test)]
fn sample([a, b]: [f64; 2], stated: f64, sharper: f64) -> tautline_statements::Evidence {
    use tautline_statements::{Evidence, Statement, Unit};
    Evidence::of(Statement::Theorem1_1)
        .given("a ≤ 1", Unit::NONE, [a, 1.0], 0.0)
        .given("b ≤ 1", Unit::NONE, [b, 1.0], 0.0)
        .stated("stated ≤ 1", Unit::ENERGY, [stated, 1.0], 0.0)
        .sharper("sharper ≤ 1", Unit::ENERGY, [sharper, 1.0], 0.0)
}
