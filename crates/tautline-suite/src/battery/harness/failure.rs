//! `Failure`: why a check failed.

use tautline_chance::Chance;
use tautline_statements::VerifyError;

use super::{Case, Tally};

/// Why a check failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// The two numbers, the claim, and the case; the smallest one found if cases are random.
    pub message: String,
    /// That case, if it is a random one.
    pub case: Option<Case>,
}

impl Failure {
    /// Returns a failure with this message.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), case: None }
    }

    /// Returns the full report for the check of this name: the numbers, the command that draws the
    /// same cases again, and a test that keeps the smallest of them.
    #[must_use]
    pub fn of_check(&self, name: &str, chance: Chance) -> String {
        let again = format!("{self}\nagain: {chance}cargo test -p tests {name}");
        match &self.case {
            Some(case) => {
                let test = case.as_test(name);
                format!("{again}\nto keep it, in tests/src/promoted_cases.rs:\n\n{test}")
            }
            None => again,
        }
    }
}

/// Every error that keeps a statement from being evaluated fails the check.
impl<E> From<E> for Failure
where
    VerifyError: From<E>,
{
    fn from(error: E) -> Self {
        Self::new(VerifyError::from(error).to_string())
    }
}

/// The result of a check: its tally, or why it failed.
pub type Outcome = Result<Tally, Failure>;
