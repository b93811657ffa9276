//! `VerifyError`: why a statement could not be evaluated.

use crate::Statement;
use tautline::{
    CertifyError, Curvature, HypothesisError, LocalError, MetricError, SequenceError, SetError,
    SolveError, Stop,
    bounds::{BoundError, LocalityError},
    gallery::GalleryError,
};

/// Why a statement could not be evaluated on a case. Not a violation of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// The solver refused the problem.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The solver did not converge to a local minimum: its result says nothing of minimisers.
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
    /// Points are no point sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A number is no distance, or a dimension is zero.
    #[error(transparent)]
    Bound(#[from] BoundError),
    /// A metric has no constants on a ball.
    #[error(transparent)]
    Local(#[from] LocalError),
    /// A constant could not be proved.
    #[error(transparent)]
    Certify(#[from] CertifyError),
    /// No region holds all competitors.
    #[error(transparent)]
    Locality(#[from] LocalityError<LocalError>),
    /// A set is refused.
    #[error(transparent)]
    Set(#[from] SetError),
    /// Constants are refused.
    #[error(transparent)]
    Constants(#[from] HypothesisError),
    /// The numbers of one case do not scale by their unit.
    #[error("{claim}: in other units {found:?}, where {expected:?} were expected")]
    NotHomogeneous {
        /// The claim.
        claim: &'static str,
        /// The two numbers as they should be in the other units.
        expected: [f64; 2],
        /// The two numbers as they are.
        found: [f64; 2],
    },
    /// A witness does not come as near equality as it should.
    #[error(
        "{statement}: the overestimation of the witness is {overestimation}, not at most {known}"
    )]
    NotAttained {
        /// The statement.
        statement: Statement,
        /// The least overestimation of the paper's conclusions, a pure number.
        overestimation: f64,
        /// The least overestimation that is known.
        known: f64,
    },
    /// A witness against the printed form of a statement does not refute it.
    #[error("{statement}: the witness does not refute it")]
    NotRefuted {
        /// The statement.
        statement: Statement,
    },
    /// A metric of the gallery is refused.
    #[error(transparent)]
    Gallery(#[from] GalleryError),
    /// A parameter of the case is out of its range.
    #[error("{name} = {value} must lie in [{low}, {high}]")]
    OutOfRange {
        /// The parameter.
        name: &'static str,
        /// The number that was given.
        value: f64,
        /// The least number that is allowed.
        low: f64,
        /// The largest number that is allowed.
        high: f64,
    },
}
