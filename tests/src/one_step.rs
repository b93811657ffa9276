//! The witnesses of equality of Sections 7 and 8: sequences of one step, and metrics on the line
//! for which nothing is given away there.

use tautline::{Constants, Metric, PointSequence, SMatrix, SVector, Scalar};

/// `H = 2 + L |x − ½|`: a valley with straight sides at the middle of `[0, 1]`. Not smooth
/// there, so it is for reading values, not derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tent {
    pub(crate) l_h: f64,
}

impl Metric<1> for Tent {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        // √((x − ½)²) is the modulus, to the last bit.
        SMatrix::from_diagonal_element((x[0] - 0.5).sqr().sqrt() * self.l_h + 2.0)
    }
}

/// `H = 2 + L x`, positive on `[0, 1]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Incline {
    pub(crate) l_h: f64,
}

impl Metric<1> for Incline {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0] * self.l_h + 2.0)
    }
}

/// The constants of both on `[0, 1]`, of which only `L_H` enters the propositions.
pub(crate) fn constants(l_h: f64) -> Constants {
    Constants::new(2.0, 2.0 + l_h, l_h).expect("in order")
}

/// `N + 1` points on the line that rest at 0, go to 1 in the step `step`, and rest there.
pub(crate) fn one_step(n: usize, step: usize) -> PointSequence<1> {
    let points = (0..=n).map(|k| SVector::from([if k <= step { 0.0 } else { 1.0 }])).collect();
    PointSequence::new(points).expect("two points at least")
}

/// `(1/N) Σ |βₙ|³`, in `ℓ³`.
pub(crate) fn mean_cube<const D: usize>(sequence: &PointSequence<D>) -> f64 {
    sequence.differences().map(|beta| beta.norm().powi(3)).sum::<f64>() / sequence.n().get() as f64
}
