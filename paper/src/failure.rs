//! `Failure`: why a figure or table could not be made, or was refused.

use std::{error::Error, path::PathBuf};

/// Why a figure or table could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Failure {
    /// The arguments of the command are wrong.
    #[error("{0}")]
    Usage(String),
    /// A library returned an error.
    #[error(transparent)]
    Library(Box<dyn Error + Send + Sync>),
    /// The distance of a case is not known.
    #[error("{0}: the distance is not known")]
    NoReference(&'static str),
    /// A method ended before it had an answer.
    #[error("no answer: {0}")]
    Unfinished(String),
    /// Observations violate an inequality or an order.
    #[error("{0}")]
    Violated(String),
    /// A check of the project's own suite failed.
    #[cfg(feature = "tables")]
    #[error("a check fails: {0}")]
    Check(#[from] tautline_checks::battery::Failure),
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The error of the system.
        source: std::io::Error,
    },
    /// Data cannot be read back, drawn or set.
    #[error("{0}")]
    Data(String),
    /// A committed file differs from what was computed.
    #[error("{0}")]
    Differs(String),
}

/// Makes `?` convert errors of the libraries into failures.
macro_rules! from_libraries {
    ($($error:ty),* $(,)?) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Failure {
                Failure::Library(error.into())
            }
        }
    )*};
}

from_libraries! {
    tautline::AsymptoticsError,
    tautline::CertificateError,
    tautline::CertifyError,
    tautline::GraphPathError,
    tautline::RequestError,
    tautline::LocalError,
    tautline::MetricError,
    tautline::RecordError,
    tautline::SequenceError,
    tautline::SetError,
    tautline::SolveError,
    tautline::bounds::BoundError,
    tautline::composition::CompositionError,
    tautline::gallery::GalleryError,
    tautline::grid::EikonalError,
    tautline_baselines::collocation::CollocationError,
    tautline_baselines::descent::DescentError,
    tautline_baselines::geodesic_calculus::CalculusError,
    tautline_baselines::shooting::ShootingError,
    tautline_picture::DrawingError,
    tautline_statements::VerifyError,
}

#[cfg(feature = "tables")]
from_libraries!(tautline_checks::adversary::AdversaryError);
