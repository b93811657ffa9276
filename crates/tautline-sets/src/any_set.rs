//! `AnySet`: a closed set of a space whose dimension is known when the program runs.

use std::fmt::Debug;

use nalgebra::SVector;

use crate::ClosedSet;

/// A closed set, by its nearest-point map `P`, in a space whose dimension is a value. What takes it is
/// compiled once for all dimensions.
///
/// [`InAny`] makes one of a [`ClosedSet`]; the contract of its methods is the same.
pub trait AnySet: Debug + Send + Sync {
    /// Returns the dimension `D` of the space.
    fn dimension(&self) -> usize;

    /// Moves `x` to a nearest point of the set, in `ℓ`.
    fn project(&self, x: &mut [f64]);

    /// Writes the derivative of `P` at `x` to `derivative`, as the `D²` numbers of a symmetric matrix.
    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]);

    /// Returns `sup |x|` over the set, rounded up, in `ℓ`; `None` if the set is unbounded.
    fn radius(&self) -> Option<f64>;

    /// Returns further points of the set, in `ℓ`, from which a local search should start.
    fn seeds(&self) -> Vec<Vec<f64>>;
}

/// A set of `R^D` as one of a space whose dimension is a value.
#[derive(Clone, Copy, Debug)]
pub struct InAny<'s, const D: usize>(pub &'s dyn ClosedSet<D>);

impl<const D: usize> AnySet for InAny<'_, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn project(&self, x: &mut [f64]) {
        // The length of an array is known at compile time.
        let x: &mut [f64; D] = x.try_into().expect("D coordinates");
        *x = self.0.project(&SVector::from(*x)).into();
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        let x: &[f64; D] = x.try_into().expect("D coordinates");
        let matrix = self.0.projection_derivative(&SVector::from(*x));
        derivative[..D * D].copy_from_slice(matrix.as_slice());
    }

    fn radius(&self) -> Option<f64> {
        self.0.radius()
    }

    fn seeds(&self) -> Vec<Vec<f64>> {
        self.0.seeds().iter().map(|x| x.as_slice().to_vec()).collect()
    }
}
