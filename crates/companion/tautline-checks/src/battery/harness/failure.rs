//! `Failure`: why a check failed.

use tautline_chance::Chance;
use tautline_statements::VerifyError;

use super::{Case, Tally};

/// Why a check failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// The two numbers, the claim, and the case. If the cases are random, it is the smallest one
    /// found.
    pub message: String,
    /// The case, if it is random.
    pub case: Option<Case>,
}

impl Failure {
    /// Returns a failure with this message.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), case: None }
    }

    /// Returns the full report for the check with this name: the numbers, the command that draws
    /// the same cases again, and a test that preserves the smallest of them.
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

/// Any error that prevents the evaluation of a statement fails the check.
impl<E> From<E> for Failure
where
    VerifyError: From<E>,
{
    fn from(error: E) -> Self {
        Self::new(VerifyError::from(error).to_string())
    }
}

/// The result of a check: its tally, or the reason why it failed.
pub type Outcome = Result<Tally, Failure>;
