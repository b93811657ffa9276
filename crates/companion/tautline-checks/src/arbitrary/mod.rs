//! Random cases for quickcheck: data of the algebraic lemmas, settings of Theorem 1.1, and
//! constants of metrics.
//!
//! Each type is a newtype over small integers, so that quickcheck shrinks to the simplest numbers
//! that still fail. Every case, drawn or shrunk, satisfies its hypotheses.

mod any_constants;
mod any_setting;
mod nonnegatives;
mod two_forms;

pub use any_constants::AnyConstants;
pub use any_setting::AnySetting;
pub use nonnegatives::Nonnegatives;
pub use two_forms::AnyTwoForms;

/// Checks a law on random cases of its arguments.
#[cfg(test)]
fn holds(seed: u64, cases: u32, law: impl quickcheck::Testable) {
    quickcheck::QuickCheck::new()
        .rng(quickcheck::Gen::from_size_and_seed(24, tautline_chance::seed(seed)))
        .tests(u64::from(tautline_chance::cases(cases)))
        .quickcheck(law);
}
