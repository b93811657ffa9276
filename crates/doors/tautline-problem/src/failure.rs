//! `Failure`: why there is no answer.

use crate::Diagnostic;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Failure {
    /// The file is wrong.
    #[error(transparent)]
    BadInput(#[from] Diagnostic),
    /// The file is right, but nothing was computed or proved.
    #[error("{0}")]
    NotComputed(String),
}
