//! `AsymptoticsError`: why an error has no leading constant, or none that can be told.

use tautline_metrics::MetricError;

/// Why there are no leading constants.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AsymptoticsError {
    /// The metric is not one at the middle of a chord.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The search did not end at a strict local minimum, or the Hessian between these ends is not
    /// positive definite: the minimiser may be one of a continuum, and the expansion fails.
    #[error("the minimiser is degenerate, or the search has not found one")]
    Degenerate,
    /// The trapezoidal energy can still be lowered between these ends: the minimiser is that of
    /// another rule, metric or pair of sets.
    #[error(
        "a Newton step still lowers the trapezoidal energy between these ends by {decrement:e} of \
         it, more than 1e-10"
    )]
    NotStationary {
        /// What the step promises to shed, relative to the energy.
        decrement: f64,
    },
}
