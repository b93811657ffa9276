//! `Failure`: why a figure or table could not be made, or was refused.

use std::path::PathBuf;

use tautline::{
    AsymptoticsError, CertifyError, LocalError, RecordError, SequenceError, SetError, SolveError,
    bounds::BoundError, gallery::GalleryError,
};
use tautline_statements::VerifyError;

use crate::drawing::DrawingError;

/// What went wrong.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Failure {
    /// The arguments of the command.
    #[error("{0}")]
    Usage(String),
    /// A set.
    #[error(transparent)]
    Set(#[from] SetError),
    /// A metric.
    #[error(transparent)]
    Gallery(#[from] GalleryError),
    /// A formula that cannot be recorded.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// Constants on a ball.
    #[error(transparent)]
    Local(#[from] LocalError),
    /// Constants that could not be proved.
    #[error(transparent)]
    Certify(#[from] CertifyError),
    /// A point sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A problem that the solver refuses.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// Leading constants that do not exist, or cannot be told.
    #[error(transparent)]
    Asymptotics(#[from] AsymptoticsError),
    /// A bound.
    #[error(transparent)]
    Bound(#[from] BoundError),
    /// A statement that could not be evaluated.
    #[error(transparent)]
    Verify(#[from] VerifyError),
    /// A search that met a violated statement.
    #[cfg(feature = "tables")]
    #[error(transparent)]
    Adversary(#[from] tautline_adversary::AdversaryError),
    /// A drawing.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// A case without a reference value.
    #[error("{0}: the distance is not known")]
    NoReference(&'static str),
    /// An inequality or an order that the observations violate.
    #[error("{0}")]
    Violated(String),
    /// A check of the project's own suite.
    #[cfg(feature = "tables")]
    #[error("a check fails: {0}")]
    Check(#[from] tautline_suite::battery::Failure),
    /// A file.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A data file that cannot be read back.
    #[error("{0}")]
    Data(String),
    /// What is committed differs from what was computed.
    #[error("{0}")]
    Differs(String),
}
