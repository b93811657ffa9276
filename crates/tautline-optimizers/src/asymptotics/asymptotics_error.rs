//! `AsymptoticsError`: why the leading constants cannot be computed.

use tautline_metrics::MetricError;

/// Why the leading constants cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AsymptoticsError {
    /// The metric is not positive definite at the middle of a chord.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The search did not end at a strict local minimum, or the Hessian between these ends is not
    /// positive definite: the minimiser may be one of a continuum, where the expansion fails.
    #[error("the minimiser is degenerate, or the search has not found one")]
    Degenerate,
    /// A Newton step lowers the trapezoidal energy between these ends: the minimiser belongs to
    /// another rule, metric or pair of sets.
    #[error(
        "a Newton step still lowers the trapezoidal energy between these ends by {decrement:e} of \
         it, more than 1e-10"
    )]
    NotStationary {
        /// The energy that the step promises to shed, relative to the energy.
        decrement: f64,
    },
}
