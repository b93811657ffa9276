//! The sum of two metrics on the same space: `H + H′`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::{Bounded, Constants, LocalError, LocallyBounded, Metric};

/// `H(x) + H′(x)`: the squared speeds in the two metrics add up.
///
/// Its distance is at least `√(d² + d′²)`, with equality if one curve is minimal in both metrics,
/// with proportional speeds. In general `d` and `d′` do not determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum<A, B> {
    first: A,
    second: B,
}

impl<A, B> Sum<A, B> {
    /// Returns the sum of two metrics.
    #[must_use]
    pub const fn new(first: A, second: B) -> Self {
        Self { first, second }
    }
}

impl<A: Metric<D>, B: Metric<D>, const D: usize> Metric<D> for Sum<A, B> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.first.gram(x) + self.second.gram(x)
    }
}

impl<A: Bounded<D>, B: Bounded<D>, const D: usize> Bounded<D> for Sum<A, B> {
    /// Returns the sums of the constants ([`Constants::plus`]).
    ///
    /// # Panics
    ///
    /// If a sum overflows.
    fn constants(&self) -> Constants {
        self.first
            .constants()
            .plus(self.second.constants())
            .expect("constants whose sum is within the range of f64")
    }
}

impl<A: LocallyBounded<D>, B: LocallyBounded<D>, const D: usize> LocallyBounded<D> for Sum<A, B> {
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        let first = self.first.constants_within(centre, radius)?;
        Ok(first.plus(self.second.constants_within(centre, radius)?)?)
    }
}
