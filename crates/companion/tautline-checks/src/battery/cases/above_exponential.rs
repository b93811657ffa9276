//! `AboveExponential`: an unbounded closed set that comes arbitrarily close to the axis.

use nalgebra::{SMatrix, SVector};
use tautline::ClosedSet;

/// The closed set `{x₂ ≥ e^{−x₁}}` in the plane; Newton's method finds its nearest points.
#[derive(Debug)]
pub(crate) struct AboveExponential;

impl ClosedSet<2> for AboveExponential {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        if x[1] >= (-x[0]).exp() {
            return *x;
        }
        // s ↦ (s − x₁)² + (e^{−s} − x₂)² is convex where e^{−s} > x₂, which holds to the left of
        // the root.
        let mut s = x[0];
        for _ in 0..100 {
            let e = (-s).exp();
            let slope = (s - x[0]) - e * (e - x[1]);
            s -= slope / (1.0 + e * (2.0 * e - x[1]));
        }
        SVector::from([s, (-s).exp()])
    }

    fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::identity()
    }

    fn radius(&self) -> Option<f64> {
        None
    }

    fn is_convex(&self) -> bool {
        true
    }
}
