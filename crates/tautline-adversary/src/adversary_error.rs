//! `AdversaryError`: why a search ended without a tightest case.

use tautline_statements::{Statement, VerifyError};

/// A search that met something worse than a tight case.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AdversaryError {
    /// The hypotheses of a statement hold and one of its conclusions does not.
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
    /// A statement could not be evaluated, for another reason than a solver that found no minimum.
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
