//! A closed half-space.

use std::cmp::Ordering;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::numerics::norm::norm;
use crate::numerics::place::{Place, add, diagonal, dot, largest, tangential, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite, finite_vector, known};
use crate::{AnySet, ClosedSet, Shape};

/// The half-space `n·x ≤ b`, which is unbounded. With `|n| = 1`:
///
/// ```text
/// P(x) = x   and DP(x) = I                        for n·x ≤ b,
/// P(x) = x − (n·x − b) n   and   DP(x) = I − nnᵀ   outside.
/// ```
///
/// Two half-spaces are equal if their normalised `n` and `b` are.
#[derive(Clone, Debug)]
pub struct HalfSpace<const D: usize> {
    /// The normal `n`, of length 1.
    normal: Box<[f64]>,
    offset: f64,
    /// The normal and the offset as given. They define the half-space exactly, while the normalised
    /// ones are rounded.
    given_normal: Box<[f64]>,
    given_offset: f64,
}

impl<const D: usize> PartialEq for HalfSpace<D> {
    fn eq(&self, other: &Self) -> bool {
        (&self.normal, self.offset) == (&other.normal, other.offset)
    }
}

impl<const D: usize> HalfSpace<D> {
    /// Returns the half-space `normal·x ≤ offset`. The normal points out of the set and need not
    /// have length 1. The offset is in `ℓ` times the unit of the normal.
    ///
    /// ```
    /// # use nalgebra::vector;
    /// # use tautline_sets::{ClosedSet, HalfSpace, SetError};
    /// // −x₁ ≤ −2, that is x₁ ≥ 2.
    /// let wall = HalfSpace::new([-1.0, 0.0], -2.0)?;
    /// assert_eq!(wall.project(&vector![0.0, 7.0]), vector![2.0, 7.0]);
    /// # Ok::<(), SetError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] or [`SetError::ZeroNormal`] if the normal is not finite or
    /// is zero; [`SetError::NonFinite`] if the offset is not finite or `offset / |normal|`
    /// overflows.
    pub fn new(normal: impl Into<SVector<f64, D>>, offset: f64) -> Result<HalfSpace<D>, SetError> {
        HalfSpace::from_slice(normal.into().as_slice(), offset)
    }

    /// Returns the half-space whose normal has these coordinates.
    ///
    /// # Errors
    ///
    /// As for [`HalfSpace::new`]; also [`SetError::Coordinates`] if there are not `D` coordinates.
    pub fn from_slice(normal: &[f64], offset: f64) -> Result<HalfSpace<D>, SetError> {
        let given_normal = finite_vector("the normal", normal, known(D))?;
        let given_offset = finite("offset", offset)?;
        // The normal is divided by its largest coordinate first, since |normal| itself may
        // overflow.
        let largest = largest(normal);
        if largest == 0.0 {
            return Err(SetError::ZeroNormal);
        }
        let scaled: Place = normal.iter().map(|n| n / largest).collect();
        let length = norm(&scaled);
        Ok(HalfSpace {
            normal: scaled.iter().map(|n| n / length).collect(),
            offset: finite("offset / |normal|", offset / largest / length)?,
            given_normal,
            given_offset,
        })
    }

    /// Returns the half-space `normal·x ≥ offset`, with a normal that points into the set.
    ///
    /// # Errors
    ///
    /// As for [`HalfSpace::new`].
    pub fn at_least(
        normal: impl Into<SVector<f64, D>>,
        offset: f64,
    ) -> Result<HalfSpace<D>, SetError> {
        let normal = normal.into();
        // The numbers are checked before the signs change, so that errors show the given ones.
        finite_vector("the normal", normal.as_slice(), known(D))?;
        HalfSpace::new(-normal, -finite("offset", offset)?)
    }

    /// Returns the outward normal `n` of length 1, a vector of pure numbers.
    #[must_use]
    pub fn normal(&self) -> &SVector<f64, D> {
        vector(&self.normal)
    }

    /// Returns the normal and the offset as they were given, which define the half-space exactly.
    #[must_use]
    pub fn given(&self) -> (&SVector<f64, D>, f64) {
        (vector(&self.given_normal), self.given_offset)
    }

    /// Returns the coordinates of the normal as it was given, and the offset.
    #[must_use]
    pub fn given_slice(&self) -> (&[f64], f64) {
        (&self.given_normal, self.given_offset)
    }

    /// Returns the `b` that belongs to the normal of length 1, in `ℓ`.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "half_space",
        name: "a half-space",
        about: "The half-space `normal·x ≥ at_least`, or `normal·x ≤ at_most`.",
        parts: &[
            Part::vector("normal", "A vector orthogonal to the boundary, of any length but 0.")
                .directions(),
            Part::side("The least or the largest value of `normal·x`."),
        ],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let (normal, offset): (Vec<f64>, f64) = match values {
            [Value::Vector(normal), Value::AtMost(offset)] => (normal.clone(), *offset),
            [Value::Vector(normal), Value::AtLeast(offset)] => {
                (normal.iter().map(|n| -n).collect(), -offset)
            }
            _ => return None,
        };
        Some(HalfSpace::from_slice(&normal, offset))
    }

    pub(crate) fn cast<const E: usize>(self) -> HalfSpace<E> {
        let Self { normal, offset, given_normal, given_offset } = self;
        HalfSpace { normal, offset, given_normal, given_offset }
    }

    /// Returns `n·x − b` for the normal of length 1.
    pub(crate) fn height(&self, x: &[f64]) -> f64 {
        dot(&self.normal, x) - self.offset
    }

    /// Moves a point against the normal.
    pub(crate) fn sink(&self, x: &mut [f64], by: f64) {
        add(x, &self.normal, -by);
    }
}

impl<const D: usize> AnySet for HalfSpace<D> {
    fn dimension(&self) -> usize {
        self.normal.len()
    }

    fn project(&self, x: &mut [f64]) {
        let n = &self.normal;
        let height = dot(n, x);
        if height <= self.offset {
            return;
        }
        // x − (n·x − b) n suffers from cancellation if x is far out, and misses the plane by ε|x|.
        // Instead the whole component along n is removed twice: the first time leaves ε|x|, the
        // second ε² |x|. Adding b n rounds once.
        add(x, n, -height);
        let rest = dot(n, x);
        add(x, n, -rest);
        add(x, n, self.offset);
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        if dot(&self.normal, x) <= self.offset {
            diagonal(derivative, x.len(), |_| 1.0);
        } else {
            tangential(&self.normal, 1.0, derivative);
        }
    }

    fn radius(&self) -> Option<f64> {
        None
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let (n, b) = (&self.given_normal, self.given_offset);
        if proof::compare_height(n, x, b).is_some_and(Ordering::is_le) {
            return Some(proof::point(x));
        }
        let unit = proof::power_of_two(largest(n));
        let n: Vec<Interval> = n.iter().map(|&n| Interval::point(n) / unit).collect();
        let b = Interval::point(b) / unit;
        // Start near the plane, where x − (n·x − b) n/|n|² does not cancel. The starting point is
        // free, since the foot of any point is a member.
        let mut near = Place::from_slice(x);
        AnySet::project(self, &mut near);
        let near = proof::point(&near);
        let step = (proof::dot(&n, &near) - b) / proof::square(&n);
        proof::finite(near.iter().zip(&n).map(|(&near, &n)| near - n * step).collect())
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::HalfSpace(self.clone().cast()))
    }
}

impl<const D: usize> Piece for HalfSpace<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        let (normal, offset) = self.given_slice();
        vec![Value::Vector(normal.to_vec()), Value::AtMost(offset)]
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        Vec::new()
    }

    fn has(&self, x: &[f64]) -> bool {
        let (normal, offset) = self.given_slice();
        proof::compare_height(normal, x, offset).is_some_and(Ordering::is_le)
    }
}

impl<const D: usize> ClosedSet<D> for HalfSpace<D> {
    closed_set_in_any!(self => Shape::HalfSpace(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::HalfSpace;
    use crate::laws::{Case, check, check_inside, scale, vector_in};
    use crate::numerics::exact::{Exact, least_product};
    use crate::numerics::norm::on_axis;
    use crate::{ClosedSet, SetError};
    use nalgebra::{Matrix2, Matrix3, vector};
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let normal = vector_in::<D>(3.0).prop_filter("the normal is not zero", |n| n.norm() > 0.01);
        (normal, -3.0..3.0_f64, scale()).prop_map(|(n, b, scale)| {
            let height = move |x: &nalgebra::SVector<f64, D>| (n.dot(x) - b) / n.norm();
            Case {
                // The point is reflected at the plane if it is outside.
                member: Box::new(move |w| {
                    let y = w * 4.0;
                    if height(&y) > 0.0 { y - n * (2.0 * height(&y) / n.norm()) } else { y }
                }),
                defect: Box::new(move |x| height(x).max(0.0)),
                held: Box::new(move |y| least_product(&n, y).at_most(&Exact::new(b))),
                kink: Box::new(move |x| height(x).abs()),
                farthest: None,
                set: Box::new(HalfSpace::new(n, b * scale).expect("finite")),
                scale,
            }
        })
    }

    #[test]
    fn half_space_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<5>());
    }

    #[test]
    fn the_inside_and_the_boundary_of_a_half_space_stay() {
        check_inside(case::<1>());
        check_inside(case::<2>());
        check_inside(case::<5>());
    }

    #[test]
    fn half_space_boundary_counts_as_inside() {
        let wall = HalfSpace::new([-1.0, 0.0], -2.0).expect("a normal");
        assert_eq!(wall.projection_derivative(&vector![2.0, 5.0]), Matrix2::identity());
        let outside = wall.projection_derivative(&vector![1.0, 5.0]);
        assert_eq!(outside, Matrix2::new(0.0, 0.0, 0.0, 1.0));
        assert_eq!(HalfSpace::at_least([1.0, 0.0], 2.0), Ok(wall));
    }

    /// Tests the faces on every axis, in both directions, where nothing rounds.
    #[test]
    fn half_space_faces_belong_to_it() {
        for (i, sign) in (0..3).flat_map(|i| [(i, 1.0), (i, -1.0)]) {
            let wall = HalfSpace::new(on_axis::<3>(i, sign), 0.75 * sign).expect("a normal");
            let mut x = vector![-4.5, 2.25, 8.0];
            x[i] = 0.75;
            assert_eq!(wall.projection_derivative(&x), Matrix3::identity());
            assert_eq!(wall.project(&x), x);
            x[i] += sign * f64::EPSILON;
            assert_eq!(wall.projection_derivative(&x)[(i, i)], 0.0);
            x[i] = 0.75;
            assert_eq!(wall.project(&(x + on_axis(i, 2.0 * sign))), x);
        }
    }

    #[test]
    fn half_spaces_differ_in_the_normal_or_in_the_offset() {
        let wall = |normal: [f64; 2], offset| HalfSpace::new(normal, offset).expect("a normal");
        assert_eq!(wall([1.0, 0.0], 1.0), wall([4.0, 0.0], 4.0));
        assert_ne!(wall([1.0, 0.0], 1.0), wall([1.0, 0.0], 2.0));
        assert_ne!(wall([1.0, 0.0], 1.0), wall([0.0, 1.0], 1.0));
        assert_ne!(wall([1.0, 0.0], 0.0), wall([-1.0, 0.0], 0.0));
    }

    /// For `x₁ + x₂ ≤ 1` the offset divided by the length of the normal is `1/√2`.
    #[test]
    fn half_space_offset_is_in_the_unit_of_the_normal() {
        for unit in [1e-300, 1.0, 1e300, f64::MAX] {
            let wall = HalfSpace::new([unit, unit], unit).expect("a normal");
            // The offset is computed with three roundings.
            assert!((wall.offset() - 0.5_f64.sqrt()).abs() <= 2.0 * f64::EPSILON, "{wall:?}");
        }
    }

    #[test]
    fn half_space_projection_is_accurate_from_far_away() {
        // The textbook formula would give x₁ = 0, since 1e20 − 2 is 1e20 in f64.
        let axis = HalfSpace::new([1.0, 0.0], 2.0).expect("a normal");
        assert_eq!(axis.project(&vector![1e20, 3.0]), vector![2.0, 3.0]);
        // In an oblique direction the error is a few roundings of P(x), which is about 3 long, and
        // not of x.
        let slant = HalfSpace::new([0.6, 0.8], 2.0).expect("a normal");
        let p = slant.project(&vector![6.123e9, 8.164e9]);
        assert!((slant.normal().dot(&p) - 2.0).abs() <= 4.0 * f64::EPSILON * p.norm());
        // The proved member is as near as the projection.
        for (wall, x) in [(axis, vector![1e20, 3.0]), (slant, vector![6.123e9, 8.164e9])] {
            let (near, p) = (wall.member_near(&x).expect("a member"), wall.project(&x));
            for i in 0..2 {
                let far = (near[i].lo() - p[i]).abs().max((near[i].hi() - p[i]).abs());
                assert!(far <= 16.0 * f64::EPSILON * p.norm(), "{near:?} for {p:?}");
            }
        }
    }

    #[test]
    fn half_space_normal_may_be_of_any_length() {
        let expected = HalfSpace::new([1.0, 1.0], 0.0).expect("a normal");
        for length in [5e-324, 1e-200, 1.0, 1e200, f64::MAX] {
            assert_eq!(HalfSpace::new([length, length], 0.0), Ok(expected.clone()));
        }
    }

    #[test]
    fn half_space_refuses_a_zero_normal_and_a_bad_offset() {
        assert_eq!(HalfSpace::new([0.0, 0.0], 1.0), Err(SetError::ZeroNormal));
        assert!(matches!(
            HalfSpace::new([1.0, f64::NAN], 1.0),
            Err(SetError::NonFiniteCoordinate { what: "the normal", index: 1, .. })
        ));
        assert_eq!(
            HalfSpace::new([1.0, 0.0], f64::INFINITY),
            Err(SetError::NonFinite { what: "offset", value: f64::INFINITY })
        );
        assert_eq!(
            HalfSpace::new([1e-300, 0.0], 1e300),
            Err(SetError::NonFinite { what: "offset / |normal|", value: f64::INFINITY })
        );
    }
}
