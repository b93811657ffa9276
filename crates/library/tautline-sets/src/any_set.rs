//! `AnySet`: a closed set of a space whose dimension is known when the program runs.

use std::fmt::Debug;
use std::sync::Arc;

use nalgebra::SVector;
use tautline_scalar::{ANY, Interval};

use crate::{ClosedSet, Shape};

/// A closed set, by its nearest-point map `P`, in a space whose dimension is a value. What takes it is
/// compiled once for all dimensions.
///
/// The sets of this crate are such sets, and [`InAny`] makes one of any [`ClosedSet`]. The contract of
/// the methods is that of the methods of a `ClosedSet`.
pub trait AnySet: Debug + Send + Sync {
    /// Returns the dimension `D` of the space.
    fn dimension(&self) -> usize;

    /// Moves `x` to a nearest point of the set, in `ℓ`.
    fn project(&self, x: &mut [f64]);

    /// Writes the derivative of `P` at `x` to `derivative`, as the `D²` numbers of a symmetric matrix.
    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]);

    /// Returns `sup |x|` over the set, rounded up, in `ℓ`; `None` if the set is unbounded.
    fn radius(&self) -> Option<f64>;

    /// Returns the centre and the radius of a ball that contains the set, in `ℓ`; `None` if the set is
    /// unbounded. The default is a ball about the origin.
    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        Some((vec![0.0; self.dimension()], self.radius()?))
    }

    /// Returns whether the set is known to be convex. `false` claims nothing.
    fn is_convex(&self) -> bool {
        false
    }

    /// Returns a box that certainly contains a member of the set, as near to `x` as the set can prove,
    /// in `ℓ`; `[x, x]` if and only if `x` is proved to be a member. The default is `None`.
    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let _ = x;
        None
    }

    /// Returns the set as data, if it is a [`Shape`]. The default is `None`.
    fn shape(&self) -> Option<Shape<ANY>> {
        None
    }

    /// Returns the members of a union, each of which is searched separately; empty for a single piece.
    fn pieces(&self) -> Vec<Arc<dyn AnySet>> {
        Vec::new()
    }

    /// Returns further points of the set, in `ℓ`, from which a local search should start.
    fn seeds(&self) -> Vec<Vec<f64>> {
        Vec::new()
    }
}

/// Implements [`AnySet`] by delegating to another set.
macro_rules! any_set_by {
    ($self:ident => $set:expr) => {
        fn dimension(&$self) -> usize {
            $set.dimension()
        }

        fn project(&$self, x: &mut [f64]) {
            $set.project(x);
        }

        fn projection_derivative(&$self, x: &[f64], derivative: &mut [f64]) {
            $set.projection_derivative(x, derivative);
        }

        fn radius(&$self) -> Option<f64> {
            $set.radius()
        }

        fn enclosing_ball(&$self) -> Option<(Vec<f64>, f64)> {
            $set.enclosing_ball()
        }

        fn is_convex(&$self) -> bool {
            $set.is_convex()
        }

        fn member_near(&$self, x: &[f64]) -> Option<Vec<Interval>> {
            $set.member_near(x)
        }

        fn shape(&$self) -> Option<Shape<ANY>> {
            $set.shape()
        }

        fn pieces(&$self) -> Vec<Arc<dyn AnySet>> {
            $set.pieces()
        }

        fn seeds(&$self) -> Vec<Vec<f64>> {
            $set.seeds()
        }
    };
}

impl<S: AnySet + ?Sized> AnySet for &S {
    any_set_by!(self => (**self));
}

impl<const D: usize> AnySet for Arc<dyn ClosedSet<D>> {
    any_set_by!(self => InAny(&**self));
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

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        self.0.enclosing_ball().map(|(centre, radius)| (centre.as_slice().to_vec(), radius))
    }

    fn is_convex(&self) -> bool {
        self.0.is_convex()
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let member = self.0.member_near(&SVector::from_column_slice(x))?;
        Some(member.as_slice().to_vec())
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        self.0.shape().map(Shape::into_any)
    }

    fn pieces(&self) -> Vec<Arc<dyn AnySet>> {
        self.0.pieces().into_iter().map(|piece| Arc::new(piece) as Arc<dyn AnySet>).collect()
    }

    fn seeds(&self) -> Vec<Vec<f64>> {
        self.0.seeds().iter().map(|x| x.as_slice().to_vec()).collect()
    }
}

/// Implements [`ClosedSet`] for a set of this crate, which is an [`AnySet`] and a [`Shape`].
macro_rules! closed_set_in_any {
    ($self:ident => $shape:expr) => {
        fn project(&$self, x: &SVector<f64, D>) -> SVector<f64, D> {
            let mut nearest = *x;
            AnySet::project($self, nearest.as_mut_slice());
            nearest
        }

        fn projection_derivative(&$self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
            let mut derivative = SMatrix::<f64, D, D>::zeros();
            AnySet::projection_derivative($self, x.as_slice(), derivative.as_mut_slice());
            derivative
        }

        fn radius(&$self) -> Option<f64> {
            AnySet::radius($self)
        }

        fn enclosing_ball(&$self) -> Option<(SVector<f64, D>, f64)> {
            let (centre, radius) = AnySet::enclosing_ball($self)?;
            Some((SVector::from_column_slice(&centre), radius))
        }

        fn is_convex(&$self) -> bool {
            AnySet::is_convex($self)
        }

        fn member_near(&$self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
            AnySet::member_near($self, x.as_slice()).map(|x| SVector::from_column_slice(&x))
        }

        fn shape(&$self) -> Option<Shape<D>> {
            Some($shape)
        }

        fn seeds(&$self) -> Vec<SVector<f64, D>> {
            AnySet::seeds($self).iter().map(|x| SVector::from_column_slice(x)).collect()
        }
    };
}
pub(crate) use closed_set_in_any;
