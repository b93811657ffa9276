//! `CompositionError`: why a metric cannot be built from the given parts.

use crate::HypothesisError;

/// A number with which the parts do not make a metric.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompositionError {
    /// An entry of a matrix or of a vector is NaN or infinite.
    #[error("{name} = {value} must be finite")]
    NotFinite {
        /// The entry, as the constructor calls it.
        name: &'static str,
        /// The number that was given.
        value: f64,
    },
    /// A factor that is not positive, or a matrix that is not provably invertible.
    #[error(transparent)]
    Hypothesis(#[from] HypothesisError),
}
