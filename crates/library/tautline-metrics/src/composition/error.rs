//! `CompositionError`: the reasons why a metric cannot be built from the given parts.

use crate::HypothesisError;

/// A number that keeps the parts from forming a metric.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompositionError {
    /// An entry of a matrix or of a vector is NaN or infinite.
    #[error("{name} = {value} must be finite")]
    NotFinite {
        /// The name of the entry in the constructor.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// A factor is not positive, or a matrix is not provably invertible.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}
