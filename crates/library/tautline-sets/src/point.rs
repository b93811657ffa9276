//! A single point.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::numerics::norm::norm_above;
use crate::numerics::place::vector;
use crate::numerics::proof;
use crate::set_error::{SetError, finite_vector, known};
use crate::{AnySet, ClosedSet, Shape};

/// The set `{p}`, with `P(x) = p` and `DP = 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<const D: usize> {
    position: Box<[f64]>,
}

impl<const D: usize> Point<D> {
    /// Returns the set with the single member `position`, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite.
    pub fn new(position: impl Into<SVector<f64, D>>) -> Result<Point<D>, SetError> {
        Point::from_slice(position.into().as_slice())
    }

    /// Returns the set with the member that has these coordinates, in `ℓ`.
    ///
    /// # Errors
    ///
    /// As for [`Point::new`]; also [`SetError::Coordinates`] if there are not `D` coordinates.
    pub fn from_slice(position: &[f64]) -> Result<Point<D>, SetError> {
        Ok(Point { position: finite_vector("the point", position, known(D))? })
    }

    /// Returns the member, in `ℓ`.
    #[must_use]
    pub fn position(&self) -> &SVector<f64, D> {
        vector(&self.position)
    }

    /// Returns the coordinates of the member, in `ℓ`.
    #[must_use]
    pub fn position_slice(&self) -> &[f64] {
        &self.position
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "point",
        name: "a point",
        about: "A point: `point = [0, 0]`.",
        parts: &[Part::vector("position", "The coordinates.")],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(x)] = values else { return None };
        Some(Point::from_slice(x))
    }

    pub(crate) fn cast<const E: usize>(self) -> Point<E> {
        Point { position: self.position }
    }
}

impl<const D: usize> AnySet for Point<D> {
    fn dimension(&self) -> usize {
        self.position.len()
    }

    fn project(&self, x: &mut [f64]) {
        x.copy_from_slice(&self.position);
    }

    fn projection_derivative(&self, _x: &[f64], derivative: &mut [f64]) {
        derivative.fill(0.0);
    }

    fn radius(&self) -> Option<f64> {
        Some(norm_above(&proof::point(&self.position)))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        Some((self.position.to_vec(), 0.0))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, _x: &[f64]) -> Option<Vec<Interval>> {
        Some(proof::point(&self.position))
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::Point(self.clone().cast()))
    }
}

impl<const D: usize> Piece for Point<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        vec![Value::Vector(self.position.to_vec())]
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        vec![[self.position.to_vec(), self.position.to_vec()]]
    }

    fn has(&self, x: &[f64]) -> bool {
        *self.position == *x
    }
}

impl<const D: usize> ClosedSet<D> for Point<D> {
    closed_set_in_any!(self => Shape::Point(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::Point;
    use crate::SetError;
    use crate::laws::{Case, check, scale, vector_in};
    use crate::numerics::exact::contains;
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        (vector_in::<D>(3.0), scale()).prop_map(|(p, scale)| Case {
            member: Box::new(move |_| p),
            defect: Box::new(move |x| (x - p).norm()),
            held: Box::new(move |y| contains(y, &p)),
            // The map is constant.
            kink: Box::new(|_| f64::INFINITY),
            farthest: Some(p),
            set: Box::new(Point::new(p * scale).expect("finite")),
            scale,
        })
    }

    #[test]
    fn point_obeys_the_laws() {
        check(case::<1>());
        check(case::<3>());
    }

    #[test]
    fn point_refuses_nan_by_name() {
        let Err(SetError::NonFiniteCoordinate { what: "the point", index: 1, value }) =
            Point::new([0.0, f64::NAN])
        else {
            panic!("a NaN was accepted");
        };
        assert!(value.is_nan());
    }
}
