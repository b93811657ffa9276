//! `VerifyError`: why a statement could not be evaluated.

use crate::Statement;
use tautline::{
    CertifyError, Curvature, HypothesisError, LocalError, MetricError, SequenceError, SetError,
    SolveError, Stop,
    bounds::{BoundError, LocalityError},
    gallery::GalleryError,
};

/// Why a statement could not be evaluated on a case. This is not a violation of the statement.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// The solver refused the problem.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The solver did not converge to a local minimum.
    #[error("N = {n}: the search ended as {stop:?} with the curvature {curvature:?}")]
    NotConverged {
        /// The number of subintervals.
        n: usize,
        /// How the search stopped.
        stop: Stop,
        /// The signature of the Hessian.
        curvature: Curvature,
    },
    /// The metric is not finite, symmetric and positive definite somewhere.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The points do not form a point sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A distance is negative or not finite, or a dimension is zero.
    #[error(transparent)]
    Bound(#[from] BoundError),
    /// A metric has no constants on a ball.
    #[error(transparent)]
    Local(#[from] LocalError),
    /// A constant could not be proved.
    #[error(transparent)]
    Certify(#[from] CertifyError),
    /// No region contains all competitors.
    #[error(transparent)]
    Locality(#[from] LocalityError<LocalError>),
    /// The data of a set are invalid.
    #[error(transparent)]
    Set(#[from] SetError),
    /// The constants are invalid.
    #[error(transparent)]
    Constants(#[from] HypothesisError),
    /// The numbers of a case do not scale with their unit.
    #[error("{claim}: in other units {found:?}, expected {expected:?}")]
    NotHomogeneous {
        /// The claim.
        claim: &'static str,
        /// The two expected numbers in the other units.
        expected: [f64; 2],
        /// The two numbers found.
        found: [f64; 2],
    },
    /// A witness is not as close to equality as it should be.
    #[error("{statement}: the witness has overestimation {overestimation}, above {known}")]
    NotAttained {
        /// The statement.
        statement: Statement,
        /// The least overestimation found, a pure number.
        overestimation: f64,
        /// The greatest overestimation allowed.
        known: f64,
    },
    /// A counterexample does not refute the printed form of a statement.
    #[error("{statement}: the witness does not refute it")]
    NotRefuted {
        /// The statement.
        statement: Statement,
    },
    /// The parameters of a metric of the gallery are invalid.
    #[error(transparent)]
    Gallery(#[from] GalleryError),
    /// A parameter of the case is out of its range.
    #[error("{name} = {value} must lie in [{low}, {high}]")]
    OutOfRange {
        /// The parameter.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The least value allowed.
        low: f64,
        /// The largest value allowed.
        high: f64,
    },
}
