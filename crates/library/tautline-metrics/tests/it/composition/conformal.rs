//! `φ H`, a metric that tests the rule for conformal factors. No composition of the library uses
//! this rule.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Bounded, Constants, Metric, Scalar};

/// `φ H` for a metric `φ I` and a metric `H` in the plane.
pub(crate) struct Conformal<A, B>(pub(crate) A, pub(crate) B);

impl<A: Metric<2>, B: Metric<2>> Metric<2> for Conformal<A, B> {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let phi = self.0.gram(x)[(0, 0)];
        self.1.gram(x).map(|entry| entry * phi)
    }
}

impl<A: Bounded<2>, B: Bounded<2>> Bounded<2> for Conformal<A, B> {
    fn constants(&self) -> Constants {
        self.1.constants().conformal(self.0.constants()).expect("numbers of size 1")
    }
}
