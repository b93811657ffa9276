//! A closed ball.

use std::cmp::Ordering;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value, box_around, is_at};
use crate::numerics::norm::{norm_above, polar, sum_above};
use crate::numerics::place::{diagonal, minus, tangential, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite_vector, known, valid_radius};
use crate::{AnySet, ClosedSet, Shape};

/// The ball `|x − c| ≤ r`. With `u = (x − c)/|x − c|`:
///
/// ```text
/// P(x) = x   and DP(x) = I                           for |x − c| ≤ r,
/// P(x) = c + r u   and   DP(x) = (r/|x − c|) (I − uuᵀ)   outside.
/// ```
///
/// `r = 0` is allowed: the ball is the point `c`, and `DP = 0` everywhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Ball<const D: usize> {
    centre: Box<[f64]>,
    r: f64,
}

impl<const D: usize> Ball<D> {
    /// Returns the ball of radius `r ≥ 0` about `centre`, both in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if the centre is not finite; [`SetError::NonFinite`] or
    /// [`SetError::NegativeRadius`] if the radius is not finite or is negative.
    pub fn new(centre: impl Into<SVector<f64, D>>, r: f64) -> Result<Ball<D>, SetError> {
        Ball::from_slice(centre.into().as_slice(), r)
    }

    /// Returns the ball about the point with these coordinates.
    ///
    /// # Errors
    ///
    /// As for [`Ball::new`]; also [`SetError::Coordinates`] if there are not `D` coordinates.
    pub fn from_slice(centre: &[f64], r: f64) -> Result<Ball<D>, SetError> {
        Ok(Ball { centre: finite_vector("the centre", centre, known(D))?, r: valid_radius(r)? })
    }

    /// Returns the centre `c`, in `ℓ`.
    #[must_use]
    pub fn centre(&self) -> &SVector<f64, D> {
        vector(&self.centre)
    }

    /// Returns the coordinates of the centre, in `ℓ`.
    #[must_use]
    pub fn centre_slice(&self) -> &[f64] {
        &self.centre
    }

    /// Returns `r`, in `ℓ`. It is measured from the centre, unlike [`radius`](ClosedSet::radius),
    /// which is measured from the origin.
    #[must_use]
    pub fn r(&self) -> f64 {
        self.r
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "ball",
        name: "a ball",
        about: "The ball `|x − centre| ≤ radius`.",
        parts: &[
            Part::vector("centre", "The centre."),
            Part::number("radius", "The radius, at least 0."),
        ],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(centre), Value::Number(r)] = values else { return None };
        Some(Ball::from_slice(centre, *r))
    }

    pub(crate) fn cast<const E: usize>(self) -> Ball<E> {
        Ball { centre: self.centre, r: self.r }
    }
}

impl<const D: usize> AnySet for Ball<D> {
    fn dimension(&self) -> usize {
        self.centre.len()
    }

    fn project(&self, x: &mut [f64]) {
        if let Some((distance, u)) = polar(&minus(x, &self.centre))
            && !(distance <= self.r)
        {
            let pairs = self.centre.iter().zip(&u);
            x.iter_mut().zip(pairs).for_each(|(x, (c, u))| *x = c + u * self.r);
        }
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        match polar(&minus(x, &self.centre)) {
            Some((distance, u)) if !(distance <= self.r) => {
                tangential(&u, self.r / distance, derivative);
            }
            // The ball is the point c, so P is constant.
            _ if self.r == 0.0 => derivative.fill(0.0),
            _ => diagonal(derivative, x.len(), |_| 1.0),
        }
    }

    fn radius(&self) -> Option<f64> {
        Some(sum_above(norm_above(&proof::point(&self.centre)), self.r))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        Some((self.centre.to_vec(), self.r))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        if proof::compare_distance(x, &self.centre, self.r).is_some_and(Ordering::is_le) {
            return Some(proof::point(x));
        }
        proof::on_sphere(x, &self.centre, self.r)
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::Ball(self.clone().cast()))
    }
}

impl<const D: usize> Piece for Ball<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        vec![Value::Vector(self.centre.to_vec()), Value::Number(self.r)]
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        box_around(&self.centre, self.r)
    }

    fn has(&self, x: &[f64]) -> bool {
        is_at(x, &self.centre, self.r, Ordering::is_le)
    }
}

impl<const D: usize> ClosedSet<D> for Ball<D> {
    closed_set_in_any!(self => Shape::Ball(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::Ball;
    use crate::laws::{Case, check, check_inside, extent, scale, vector_in};
    use crate::numerics::exact::{square, squared_distances};
    use crate::numerics::norm::on_axis;
    use crate::{ClosedSet, SetError};
    use nalgebra::{Matrix2, Matrix3, vector};
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        (vector_in::<D>(3.0), extent(), scale()).prop_map(|(c, r, scale)| Case {
            // The cube is shrunk to fit into the ball, since |w| ≤ √D.
            member: Box::new(move |w| c + w * (r / (D as f64).sqrt())),
            defect: Box::new(move |x| ((x - c).norm() - r).max(0.0)),
            held: Box::new(move |y| squared_distances(y, &c).0.at_most(&square(r))),
            kink: Box::new(
                move |x| {
                    if r == 0.0 { f64::INFINITY } else { ((x - c).norm() - r).abs() }
                },
            ),
            farthest: Some(c * (1.0 + r / c.norm())),
            set: Box::new(Ball::new(c * scale, r * scale).expect("finite")),
            scale,
        })
    }

    #[test]
    fn ball_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<5>());
    }

    #[test]
    fn the_inside_and_the_boundary_of_a_ball_stay() {
        check_inside(case::<1>());
        check_inside(case::<2>());
        check_inside(case::<5>());
    }

    #[test]
    fn ball_boundary_counts_as_inside() {
        let ball = Ball::new([1.0, 0.0], 2.0).expect("finite");
        assert_eq!(ball.projection_derivative(&vector![3.0, 0.0]), Matrix2::identity());
        assert_eq!(ball.project(&vector![3.0, 0.0]), vector![3.0, 0.0]);
        let outside = ball.projection_derivative(&vector![5.0, 0.0]);
        assert_eq!(outside, Matrix2::new(0.0, 0.0, 0.0, 0.5));
    }

    /// Tests the poles on every axis, where nothing rounds.
    #[test]
    fn ball_poles_belong_to_it() {
        let centre = vector![0.5, -3.0, 2.25];
        let ball = Ball::new(centre, 1.75).expect("finite");
        for (i, sign) in (0..3).flat_map(|i| [(i, 1.0), (i, -1.0)]) {
            let pole = centre + on_axis(i, 1.75 * sign);
            assert_eq!(ball.project(&pole), pole);
            assert_eq!(ball.projection_derivative(&pole), Matrix3::identity());
            let beyond = centre + on_axis(i, 3.5 * sign);
            assert_eq!(ball.project(&beyond), pole);
            let halved = Matrix3::identity() * 0.5
                - Matrix3::from_fn(|j, k| if (j, k) == (i, i) { 0.5 } else { 0.0 });
            assert_eq!(ball.projection_derivative(&beyond), halved);
        }
    }

    #[test]
    fn ball_of_radius_zero_is_a_point() {
        let ball = Ball::new([1.0, 2.0], 0.0).expect("finite");
        for x in [vector![1.0, 2.0], vector![-4.0, 7.0]] {
            assert_eq!(ball.project(&x), vector![1.0, 2.0]);
            assert_eq!(ball.projection_derivative(&x), Matrix2::zeros());
        }
    }

    #[test]
    fn ball_refuses_a_bad_radius_and_a_bad_centre() {
        assert_eq!(Ball::new([0.0], -1.0), Err(SetError::NegativeRadius { radius: -1.0 }));
        assert_eq!(
            Ball::new([0.0], f64::INFINITY),
            Err(SetError::NonFinite { what: "radius", value: f64::INFINITY })
        );
        assert!(matches!(
            Ball::new([0.0], f64::NAN),
            Err(SetError::NonFinite { what: "radius", value }) if value.is_nan()
        ));
        assert_eq!(
            Ball::new([0.0, f64::NEG_INFINITY], 1.0),
            Err(SetError::NonFiniteCoordinate {
                what: "the centre",
                index: 1,
                value: f64::NEG_INFINITY
            })
        );
    }
}
