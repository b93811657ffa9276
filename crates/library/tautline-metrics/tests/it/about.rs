//! A metric with constants on balls, seen from the centre of a ball.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Bounded, Constants, LocallyBounded, Metric, Scalar};

/// A metric seen from a point, with the constants of a ball about it.
#[derive(Debug)]
pub(crate) struct About<M, const D: usize> {
    metric: M,
    centre: SVector<f64, D>,
    constants: Constants,
}

impl<M: LocallyBounded<D>, const D: usize> About<M, D> {
    pub(crate) fn new(metric: M, centre: SVector<f64, D>, radius: f64) -> Self {
        let constants = metric.constants_within(&centre, radius).expect("inside of its domain");
        assert!(constants.is_local());
        Self { metric, centre, constants }
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for About<M, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(&SVector::from_fn(|i, _| x[i] + self.centre[i]))
    }
}

impl<M: Metric<D>, const D: usize> Bounded<D> for About<M, D> {
    fn constants(&self) -> Constants {
        self.constants
    }
}

/// Returns half of the half-width of the largest cube in a ball, since one point of a pair may be
/// twice as far out.
pub(crate) fn in_ball<const D: usize>(radius: f64) -> f64 {
    0.5 * radius / (D as f64).sqrt()
}
