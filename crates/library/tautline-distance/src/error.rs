//! `DistanceError`: why no certificate could be proposed.

use tautline_check::CheckError;

/// Why there is no certificate.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DistanceError {
    /// The wanted gap is not between 0 and 1.
    #[error("a gap of {gap:e}, which is not between 0 and 1")]
    Gap {
        /// The gap.
        gap: f64,
    },
    /// The curve does not run from set to set, or its length is not bounded.
    #[error("the curve proves no length: {0}")]
    Curve(#[source] CheckError),
    /// The length of the curve is 0 or not finite.
    #[error("the curve has the length {length}")]
    Length {
        /// The length.
        length: f64,
    },
    /// Neither set is bounded.
    #[error("one of the sets has to be bounded")]
    Unbounded,
    /// No region was found that short curves cannot leave.
    #[error("curves shorter than {hi:.4e} may leave every region that was tried: {reason}")]
    Region {
        /// The length.
        hi: f64,
        /// What the last region lacked.
        reason: CheckError,
    },
    /// No values could be proposed for the first level, since near a set no metric is defined.
    #[error("no values for the first level: near a set the metric is not defined")]
    NoValues,
    /// The checker refused a level: there is none for this dimension, or the sets are too far from the
    /// origin for cubes of the size that is needed. Every other reason is a fault of this library.
    #[error("a level was refused: {0}")]
    Refused(#[source] CheckError),
}
