//! `Equality`, and its values and derivatives along a sequence.

use nalgebra::{SMatrix, SVector};
use tautline::{Jet2, PointSequence, Scalar};

use crate::descent::search::ROUNDING;

/// An equality `c(x) = 0` that every point of a curve has to satisfy: a surface on which it runs.
///
/// ```
/// use nalgebra::SVector;
/// use tautline::Scalar;
/// use tautline_baselines::descent::Equality;
///
/// struct UnitSphere;
/// impl Equality<3> for UnitSphere {
///     fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
///         x[0].sqr() + x[1].sqr() + x[2].sqr() - 1.0
///     }
/// }
/// ```
pub trait Equality<const D: usize> {
    /// Returns `c(x)`, in whatever unit. Its derivatives follow from the formula.
    fn value<S: Scalar>(&self, x: &SVector<S, D>) -> S;
}

/// The constraint at one point, to second order.
pub(crate) struct Contact<const D: usize> {
    pub(crate) value: f64,
    pub(crate) slope: SVector<f64, D>,
    pub(crate) bend: SMatrix<f64, D, D>,
    /// The error of the value that a few roundings of the point cause, in the unit of the
    /// constraint.
    pub(crate) rounding: f64,
}

impl<const D: usize> Contact<D> {
    pub(crate) fn at(constraint: &impl Equality<D>, x: &SVector<f64, D>) -> Self {
        let jet = constraint.value(&SVector::from(Jet2::variables(&(*x).into())));
        let slope = SVector::from_fn(|i, _| jet.first(i));
        Self {
            value: jet.value(),
            slope,
            bend: SMatrix::from_fn(|i, j| jet.second(i, j)),
            rounding: ROUNDING * slope.abs().dot(&x.abs()),
        }
    }

    /// Returns whether the value is 0 up to `feasibility`, or up to rounding.
    pub(crate) fn holds(&self, feasibility: f64) -> bool {
        self.value.abs() <= feasibility.max(self.rounding)
    }
}

/// Returns the contacts of the inner points.
pub(crate) fn contacts<const D: usize>(
    constraint: &impl Equality<D>,
    sequence: &PointSequence<D>,
) -> Vec<Contact<D>> {
    let inner = &sequence.points()[1..sequence.n().get()];
    inner.iter().map(|x| Contact::at(constraint, x)).collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use nalgebra::SVector;
    use tautline::Scalar;

    use super::Equality;

    /// The unit circle, for the tests of this folder.
    pub(crate) struct Circle;

    impl Equality<2> for Circle {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            x[0].sqr() + x[1].sqr() - 1.0
        }
    }
}
