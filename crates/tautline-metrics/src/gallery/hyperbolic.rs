//! Hyperbolic space in the ball model of Poincaré: `H(x) = 4 / (1 − |x|²)² I`.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::{KnownDistance, Metric};

/// `H(x) = 4 / (1 − |x|²)² I` in the open unit ball; NaN outside, infinite on its boundary.
///
/// It is not defined on all of `R^D` and has no constant `c₂`, so none of the theorems
/// applies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hyperbolic;

impl<const D: usize> Metric<D> for Hyperbolic {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let r2 = x.iter().fold(S::zero(), |sum, xi| sum + xi.sqr());
        // The root is there to be NaN outside the ball, where (1 − |x|²)² is positive again and
        // would look like a metric.
        let root = (-r2 + 1.0).sqrt();
        SMatrix::from_diagonal_element((root.sqr().recip() * 2.0).sqr())
    }
}

impl<const D: usize> KnownDistance<D> for Hyperbolic {
    /// `arcosh(1 + 2δ) = 2 arsinh √δ` with `δ = |x − y|² / ((1 − |x|²)(1 − |y|²))`; `None` if a
    /// point is not in the open ball. The second form does not cancel for near points.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let (inner_x, inner_y) = (1.0 - x.norm_squared(), 1.0 - y.norm_squared());
        let inside = inner_x > 0.0 && inner_y > 0.0;
        inside.then(|| 2.0 * ((x - y).norm() / (inner_x * inner_y).sqrt()).asinh())
    }
}
