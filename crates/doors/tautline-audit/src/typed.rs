//! `Typed`: the metric of a file, in the form that the kit takes.

use tautline::{Constants, Formula, LocalError, LocallyBounded, Metric, SMatrix, SVector, Scalar};
use tautline_kit::MetricCase;
use tautline_statements::WithConstants;

/// The metric of a file, with constants that hold in one ball.
#[derive(Clone, Debug)]
pub(crate) struct Typed<const D: usize> {
    pub(crate) formula: Formula<D>,
    pub(crate) in_ball: Option<Constants>,
}

/// A case of the kit. One type serves constants on all of space and constants in a ball, so that
/// the laws are compiled once for each dimension.
pub(crate) type Case<const D: usize> = MetricCase<WithConstants<Typed<D>>, D>;

impl<const D: usize> Metric<D> for Typed<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.formula.gram(x)
    }
}

impl<const D: usize> LocallyBounded<D> for Typed<D> {
    /// Returns the constants of the one ball that an audit asks for.
    fn constants_within(&self, _: &SVector<f64, D>, radius: f64) -> Result<Constants, LocalError> {
        let constants = self.in_ball.map(Constants::on_a_region);
        constants.ok_or_else(|| LocalError::NotProved {
            radius,
            reason: "no constants are known".to_owned(),
            budget_spent: false,
        })
    }
}
