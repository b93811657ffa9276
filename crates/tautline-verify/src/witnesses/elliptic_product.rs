//! `EllipticProduct`: a product metric in the plane whose distance is an elliptic integral.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

/// `H(x) = diag(1 + ½ sin² x₁, 2)`.
///
/// From `(a₁, a₂)` to `(b₁, b₂)`, `d² = (E(b₁|m) − E(a₁|m))² + 2 (b₂ − a₂)²` with the incomplete
/// elliptic integral of the second kind and the parameter `m = −½`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EllipticProduct;

impl Metric<2> for EllipticProduct {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let first = x[0].sin().sqr() * 0.5 + 1.0;
        SMatrix::from_diagonal(&SVector::from([first, S::constant(2.0)]))
    }
}

impl Bounded<2> for EllipticProduct {
    /// `(½ sin² x)′ = ½ sin 2x`.
    fn constants(&self) -> Constants {
        Constants::new(1.0, 2.0, 0.5).expect("in order")
    }
}
