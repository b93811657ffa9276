//! `AsymptoticsError`: the reason why the leading constants cannot be computed.

use tautline_metrics::MetricError;

/// The reason why the leading constants cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AsymptoticsError {
    /// The metric is not positive definite at the middle of a chord.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The search did not end at a strict local minimum, or the Hessian between these ends is not
    /// positive definite. The minimiser may then be one of a continuum, for which the expansion
    /// fails.
    #[error("the minimiser is degenerate, or the search has not found one")]
    Degenerate,
    /// A Newton step lowers the trapezoidal energy between these ends, so the minimiser belongs to
    /// another rule, metric or pair of sets.
    #[error(
        "a Newton step still lowers the trapezoidal energy between these ends by {decrement:e} of \
         it, more than 1e-10"
    )]
    NotStationary {
        /// The decrease of the energy that the step predicts, relative to the energy.
        decrement: f64,
    },
}
