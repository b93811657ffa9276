//! A single point.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

use crate::norm::norm_above;
use crate::proof;
use crate::set_error::{SetError, finite_vector};
use crate::{ClosedSet, Shape};

/// The set `{p}`, with `P(x) = p` and `DP = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "crate::data::Point<D>")
)]
pub struct Point<const D: usize> {
    position: SVector<f64, D>,
}

impl<const D: usize> Point<D> {
    /// Returns the set with the single member `position`, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite.
    pub fn new(position: impl Into<SVector<f64, D>>) -> Result<Point<D>, SetError> {
        Ok(Point { position: finite_vector("the point", position)? })
    }

    /// Returns the member, in `ℓ`.
    #[must_use]
    pub fn position(&self) -> &SVector<f64, D> {
        &self.position
    }
}

impl<const D: usize> ClosedSet<D> for Point<D> {
    fn project(&self, _x: &SVector<f64, D>) -> SVector<f64, D> {
        self.position
    }

    fn projection_derivative(&self, _x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        SMatrix::zeros()
    }

    fn radius(&self) -> Option<f64> {
        Some(norm_above(&proof::point(&self.position)))
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        Some((self.position, 0.0))
    }

    fn member_near(&self, _x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        Some(proof::point(&self.position))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn shape(&self) -> Option<Shape<D>> {
        Some(Shape::Point(*self))
    }
}

#[cfg(test)]
mod tests {
    use super::Point;
    use crate::SetError;
    use crate::exact::contains;
    use crate::laws::{Case, check, scale, vector_in};
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
