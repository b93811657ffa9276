//! A sphere, without its interior.

use std::cmp::Ordering;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value, box_around, is_at};
use crate::numerics::norm::{norm_above, polar, sum_above};
use crate::numerics::place::{Place, minus, tangential, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite_vector, known, valid_radius};
use crate::{AnySet, ClosedSet, Shape};

/// The sphere `|x − c| = r`, which is convex only if `r = 0`. With `u = (x − c)/|x − c|`:
///
/// ```text
/// P(x) = c + r u,    DP(x) = (r/|x − c|) (I − uuᵀ)
/// ```
///
/// Inside the sphere the eigenvalue `r/|x − c|` exceeds 1, so the map expands.
///
/// All points of the sphere are equally near to the centre. By convention `u = e₁` there, and hence
/// `P(c) = c + r e₁`. The derivative has no limit at the centre; it is defined as `I − e₁e₁ᵀ`, the
/// projector onto the tangent space at `P(c)`.
///
/// In one dimension the sphere consists of the two points `c ± r`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere<const D: usize> {
    centre: Box<[f64]>,
    r: f64,
}

impl<const D: usize> Sphere<D> {
    /// Returns the sphere of radius `r ≥ 0` about `centre`, both in `ℓ`. For `r = 0` it is a point.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if the centre is not finite; [`SetError::NonFinite`] or
    /// [`SetError::NegativeRadius`] if the radius is not finite or is negative.
    pub fn new(centre: impl Into<SVector<f64, D>>, r: f64) -> Result<Sphere<D>, SetError> {
        Sphere::from_slice(centre.into().as_slice(), r)
    }

    /// Returns the sphere about the point with these coordinates.
    ///
    /// # Errors
    ///
    /// As for [`Sphere::new`]; also [`SetError::Coordinates`] if there are not `D` coordinates.
    pub fn from_slice(centre: &[f64], r: f64) -> Result<Sphere<D>, SetError> {
        const { assert!(D > 0, "R⁰ has no sphere") }
        Ok(Sphere { centre: finite_vector("the centre", centre, known(D))?, r: valid_radius(r)? })
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
        key: "sphere",
        name: "a sphere",
        about: "The sphere `|x − centre| = radius`.",
        parts: &[
            Part::vector("centre", "The centre."),
            Part::number("radius", "The radius, at least 0."),
        ],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(centre), Value::Number(r)] = values else { return None };
        Some(Sphere::from_slice(centre, *r))
    }

    pub(crate) fn cast<const E: usize>(self) -> Sphere<E> {
        Sphere { centre: self.centre, r: self.r }
    }

    /// Returns `|x − c|` and the direction from the centre to `x`; at the centre `None` and `e₁`.
    fn direction(&self, x: &[f64]) -> (Option<f64>, Place) {
        let first = |i: usize| if i == 0 { 1.0 } else { 0.0 };
        polar(&minus(x, &self.centre))
            .map_or_else(|| (None, (0..x.len()).map(first).collect()), |(r, u)| (Some(r), u))
    }
}

impl<const D: usize> AnySet for Sphere<D> {
    fn dimension(&self) -> usize {
        self.centre.len()
    }

    fn project(&self, x: &mut [f64]) {
        let (_, u) = self.direction(x);
        let pairs = self.centre.iter().zip(&u);
        x.iter_mut().zip(pairs).for_each(|(x, (c, u))| *x = c + u * self.r);
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        let (distance, u) = self.direction(x);
        let stretch = match distance {
            // Near the centre the quotient may overflow, and then ∞ · 0 would be NaN.
            Some(distance) => (self.r / distance).min(f64::MAX),
            None if self.r == 0.0 => return derivative.fill(0.0),
            None => 1.0,
        };
        tangential(&u, stretch, derivative);
    }

    fn radius(&self) -> Option<f64> {
        Some(sum_above(norm_above(&proof::point(&self.centre)), self.r))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        Some((self.centre.to_vec(), self.r))
    }

    fn is_convex(&self) -> bool {
        self.r == 0.0
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        if proof::compare_distance(x, &self.centre, self.r).is_some_and(Ordering::is_eq) {
            return Some(proof::point(x));
        }
        proof::on_sphere(x, &self.centre, self.r)
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::Sphere(self.clone().cast()))
    }

    /// Returns the points `c ± r eᵢ`, or no points for `r = 0`, where the sphere is a single point.
    fn seeds(&self) -> Vec<Vec<f64>> {
        if self.r == 0.0 {
            return Vec::new();
        }
        let seed = |i: usize, r: f64| -> Vec<f64> {
            let along = |j: usize| if j == i { r } else { 0.0 };
            self.centre.iter().enumerate().map(|(j, c)| c + along(j)).collect()
        };
        (0..self.centre.len()).flat_map(|i| [self.r, -self.r].map(|r| seed(i, r))).collect()
    }
}

impl<const D: usize> Piece for Sphere<D> {
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
        is_at(x, &self.centre, self.r, Ordering::is_eq)
    }
}

impl<const D: usize> ClosedSet<D> for Sphere<D> {
    closed_set_in_any!(self => Shape::Sphere(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::Sphere;
    use crate::laws::{Case, check, extent, scale, vector_in};
    use crate::numerics::exact::{square, squared_distances};
    use crate::numerics::norm::on_axis;
    use crate::{ClosedSet, SetError};
    use nalgebra::{Matrix2, SVector, vector};
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        (vector_in::<D>(3.0), extent(), scale()).prop_map(|(c, r, scale)| Case {
            // For w = 0 a fixed direction is used.
            member: Box::new(move |w: &SVector<f64, D>| {
                c + w.try_normalize(0.0).unwrap_or_else(|| on_axis(0, 1.0)) * r
            }),
            defect: Box::new(move |x| ((x - c).norm() - r).abs()),
            held: Box::new(move |y| {
                // The box is connected, so all distances between the smallest and the largest
                // occur.
                let (least, most) = squared_distances(y, &c);
                least.at_most(&square(r)) && square(r).at_most(&most)
            }),
            // P jumps at the centre and varies fast near it. A quarter of the distance from the
            // centre keeps samples at least four times as far away as from an ordinary kink.
            kink: Box::new(move |x| (x - c).norm() / 4.0),
            farthest: Some(c * (1.0 + r / c.norm())),
            set: Box::new(Sphere::new(c * scale, r * scale).expect("finite")),
            scale,
        })
    }

    #[test]
    fn sphere_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<4>());
    }

    #[test]
    fn sphere_centre_projects_to_a_fixed_point() {
        let sphere = Sphere::new([1.0, 2.0], 3.0).expect("finite");
        assert_eq!(sphere.project(&vector![1.0, 2.0]), vector![4.0, 2.0]);
        let tangent = Matrix2::new(0.0, 0.0, 0.0, 1.0);
        assert_eq!(sphere.projection_derivative(&vector![1.0, 2.0]), tangent);
    }

    #[test]
    fn sphere_derivative_exceeds_one_inside_and_never_overflows() {
        let sphere = Sphere::new([0.0, 0.0], 3.0).expect("finite");
        let inside = sphere.projection_derivative(&vector![1.5, 0.0]);
        assert_eq!(inside, Matrix2::new(0.0, 0.0, 0.0, 2.0));
        let close = sphere.projection_derivative(&vector![5e-324, 0.0]);
        assert_eq!(close, Matrix2::new(0.0, 0.0, 0.0, f64::MAX));
    }

    #[test]
    fn sphere_seeds_are_the_axis_points() {
        let sphere = Sphere::new([1.0, 2.0], 3.0).expect("finite");
        let axis = [vector![4.0, 2.0], vector![-2.0, 2.0], vector![1.0, 5.0], vector![1.0, -1.0]];
        assert_eq!(sphere.seeds(), axis);
        assert!(Sphere::new([1.0, 2.0], 0.0).expect("finite").seeds().is_empty());
    }

    #[test]
    fn sphere_refuses_a_bad_radius_and_a_bad_centre() {
        assert_eq!(Sphere::new([0.0], -0.5), Err(SetError::NegativeRadius { radius: -0.5 }));
        assert_eq!(
            Sphere::new([0.0], f64::NEG_INFINITY),
            Err(SetError::NonFinite { what: "radius", value: f64::NEG_INFINITY })
        );
        assert_eq!(
            Sphere::new([f64::INFINITY], 1.0),
            Err(SetError::NonFiniteCoordinate {
                what: "the centre",
                index: 0,
                value: f64::INFINITY
            })
        );
    }
}
