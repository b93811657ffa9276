//! `AdversaryError`: why a search failed.

use tautline_statements::{Statement, VerifyError};

/// Why a search failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AdversaryError {
    /// The hypotheses of a statement hold, but one of its conclusions fails.
    #[error("{statement} is violated in the family {family} at {parameters:?}: {conclusion}")]
    Violated {
        /// The statement.
        statement: Statement,
        /// The family.
        family: &'static str,
        /// The case, parameter by parameter.
        parameters: Vec<(&'static str, f64)>,
        /// The conclusion with its numbers.
        conclusion: String,
    },
    /// A statement could not be evaluated, and not because the solver found no minimum.
    #[error("{statement} in the family {family} at {parameters:?}: {source}")]
    Evaluation {
        /// The statement.
        statement: Statement,
        /// The family.
        family: &'static str,
        /// The case, parameter by parameter.
        parameters: Vec<(&'static str, f64)>,
        /// The reason.
        source: VerifyError,
    },
}
