//! A box with sides parallel to the axes.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::numerics::norm::{between, norm_above};
use crate::numerics::place::{Place, diagonal, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite_vector, known};
use crate::{AnySet, ClosedSet, Shape};

/// The box `lᵢ ≤ xᵢ ≤ uᵢ`.
///
/// ```text
/// P(x)ᵢ = min(max(xᵢ, lᵢ), uᵢ),    DP(x) = diag(δ),   δᵢ = 1 if lᵢ ≤ xᵢ ≤ uᵢ and lᵢ < uᵢ, else 0
/// ```
///
/// `lᵢ = uᵢ` is allowed: the box is flat in that coordinate, `P(x)ᵢ` is constant, and `δᵢ = 0`
/// everywhere. Projections lie in the box exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisBox<const D: usize> {
    lower: Box<[f64]>,
    upper: Box<[f64]>,
}

impl<const D: usize> AxisBox<D> {
    /// Returns the box `|xᵢ − cᵢ| ≤ hᵢ` with half-widths `hᵢ ≥ 0`, in `ℓ`. The corners `c ± h` are
    /// rounded.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite or a corner overflows;
    /// [`SetError::NegativeHalfWidth`] if a half-width is negative.
    pub fn new(
        centre: impl Into<SVector<f64, D>>,
        half_widths: impl Into<SVector<f64, D>>,
    ) -> Result<AxisBox<D>, SetError> {
        let (centre, half_widths) = (centre.into(), half_widths.into());
        finite_vector("the centre", centre.as_slice(), known(D))?;
        finite_vector("the vector of half-widths", half_widths.as_slice(), known(D))?;
        for (index, &half_width) in half_widths.iter().enumerate() {
            if !(half_width >= 0.0) {
                return Err(SetError::NegativeHalfWidth { index, half_width });
            }
        }
        AxisBox::from_corners(centre - half_widths, centre + half_widths)
    }

    /// Returns the box between two opposite corners, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite;
    /// [`SetError::CrossedCorners`] if a lower coordinate exceeds the upper one.
    pub fn from_corners(
        lower: impl Into<SVector<f64, D>>,
        upper: impl Into<SVector<f64, D>>,
    ) -> Result<AxisBox<D>, SetError> {
        AxisBox::from_slices(lower.into().as_slice(), upper.into().as_slice())
    }

    /// Returns the box between the corners with these coordinates, in `ℓ`.
    ///
    /// # Errors
    ///
    /// As for [`AxisBox::from_corners`]; also [`SetError::Coordinates`] if a corner has not `D`
    /// coordinates, or not as many as the other.
    pub fn from_slices(lower: &[f64], upper: &[f64]) -> Result<AxisBox<D>, SetError> {
        let lower = finite_vector("the lower corner", lower, known(D))?;
        let upper = finite_vector("the upper corner", upper, Some(lower.len()))?;
        for (index, (&lower, &upper)) in lower.iter().zip(&upper).enumerate() {
            if !(lower <= upper) {
                return Err(SetError::CrossedCorners { index, lower, upper });
            }
        }
        Ok(AxisBox { lower, upper })
    }

    /// Returns the corner `l`, in `ℓ`.
    #[must_use]
    pub fn lower(&self) -> &SVector<f64, D> {
        vector(&self.lower)
    }

    /// Returns the corner `u`, in `ℓ`.
    #[must_use]
    pub fn upper(&self) -> &SVector<f64, D> {
        vector(&self.upper)
    }

    /// Returns the coordinates of the corners `l` and `u`, in `ℓ`.
    #[must_use]
    pub fn corner_slices(&self) -> [&[f64]; 2] {
        [&self.lower, &self.upper]
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "box",
        name: "a box",
        about: "The box `lower ≤ x ≤ upper`, coordinate by coordinate.",
        parts: &[
            Part::vector("lower", "The corner with the least coordinates."),
            Part::vector("upper", "The corner with the largest coordinates."),
        ],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(lower), Value::Vector(upper)] = values else { return None };
        Some(AxisBox::from_slices(lower, upper))
    }

    pub(crate) fn cast<const E: usize>(self) -> AxisBox<E> {
        AxisBox { lower: self.lower, upper: self.upper }
    }

    /// Returns the ends of each side.
    fn sides(&self) -> impl Iterator<Item = (f64, f64)> {
        self.lower.iter().copied().zip(self.upper.iter().copied())
    }
}

impl<const D: usize> AnySet for AxisBox<D> {
    fn dimension(&self) -> usize {
        self.lower.len()
    }

    fn project(&self, x: &mut [f64]) {
        x.iter_mut().zip(self.sides()).for_each(|(x, (lower, upper))| *x = x.clamp(lower, upper));
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        diagonal(derivative, x.len(), |i| {
            let (lower, upper) = (self.lower[i], self.upper[i]);
            if lower < upper && lower <= x[i] && x[i] <= upper { 1.0 } else { 0.0 }
        });
    }

    fn radius(&self) -> Option<f64> {
        let farthest: Place = self.sides().map(|(l, u)| l.abs().max(u.abs())).collect();
        Some(norm_above(&proof::point(&farthest)))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        let centre: Vec<f64> = self.sides().map(|(l, u)| l * 0.5 + u * 0.5).collect();
        let halves = between(&self.upper, &centre).into_iter().zip(between(&centre, &self.lower));
        let sides: Vec<Interval> =
            halves.map(|(u, l)| if u.magnitude() > l.magnitude() { u } else { l }).collect();
        let radius = norm_above(&sides);
        Some((centre, radius))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        // Clamping does not round.
        let sides = x.iter().zip(self.sides());
        Some(sides.map(|(x, (lower, upper))| Interval::point(x.clamp(lower, upper))).collect())
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::AxisBox(self.clone().cast()))
    }
}

impl<const D: usize> Piece for AxisBox<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        self.corner_slices().map(|corner| Value::Vector(corner.to_vec())).to_vec()
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        vec![self.corner_slices().map(<[f64]>::to_vec)]
    }

    fn has(&self, x: &[f64]) -> bool {
        x.iter().zip(&self.lower).zip(&self.upper).all(|((x, l), u)| l <= x && x <= u)
    }
}

impl<const D: usize> ClosedSet<D> for AxisBox<D> {
    closed_set_in_any!(self => Shape::AxisBox(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::AxisBox;
    use crate::laws::{Case, check, check_edges, extent, scale, vector_in};
    use crate::{ClosedSet, SetError};
    use nalgebra::{Matrix2, SVector, vector};
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let half_widths = proptest::array::uniform::<_, D>(extent()).prop_map(SVector::from);
        (vector_in::<D>(3.0), half_widths, scale()).prop_map(|(c, h, scale)| Case {
            member: Box::new(move |w: &SVector<f64, D>| c + w.component_mul(&h)),
            defect: Box::new(move |x| ((x - c).abs() - h).max().max(0.0)),
            held: Box::new(move |y| {
                (0..D).all(|i| y[i].lo() <= c[i] + h[i] && c[i] - h[i] <= y[i].hi())
            }),
            // A flat coordinate of the projection is constant, so it has no kink.
            kink: Box::new(move |x| {
                let gaps =
                    (0..D).filter(|&i| h[i] > 0.0).map(|i| ((x[i] - c[i]).abs() - h[i]).abs());
                gaps.fold(f64::INFINITY, f64::min)
            }),
            farthest: Some(c + h.zip_map(&c, f64::copysign)),
            set: Box::new(AxisBox::new(c * scale, h * scale).expect("finite")),
            scale,
        })
    }

    #[test]
    fn axis_box_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<5>());
    }

    #[test]
    fn the_faces_of_a_box_belong_to_it() {
        check_edges(case::<1>());
        check_edges(case::<2>());
        check_edges(case::<5>());
    }

    #[test]
    fn axis_box_distinguishes_interior_face_and_corner() {
        let unit = AxisBox::from_corners([0.0, 0.0], [1.0, 1.0]).expect("ordered");
        let inside = unit.projection_derivative(&vector![0.5, 1.0]);
        let beside = unit.projection_derivative(&vector![1.5, 0.5]);
        let corner = unit.projection_derivative(&vector![1.5, -0.5]);
        assert_eq!(inside, Matrix2::identity());
        assert_eq!(beside, Matrix2::new(0.0, 0.0, 0.0, 1.0));
        assert_eq!(corner, Matrix2::zeros());
    }

    #[test]
    fn axis_box_may_be_flat() {
        let line = AxisBox::new([2.0, 0.0], [0.0, 1.0]).expect("closed");
        let derivative = line.projection_derivative(&vector![2.0, 0.0]);
        assert_eq!(derivative, Matrix2::new(0.0, 0.0, 0.0, 1.0));
        assert_eq!(line.project(&vector![5.0, 0.25]), vector![2.0, 0.25]);
    }

    #[test]
    fn axis_box_refuses_what_would_be_empty_or_infinite_by_the_first_index() {
        assert_eq!(
            AxisBox::new([0.0; 3], [1.0, -2.0, -3.0]),
            Err(SetError::NegativeHalfWidth { index: 1, half_width: -2.0 })
        );
        assert_eq!(
            AxisBox::from_corners([0.0, 2.0, 3.0], [1.0; 3]),
            Err(SetError::CrossedCorners { index: 1, lower: 2.0, upper: 1.0 })
        );
        // A half-width may be zero, with either sign.
        assert!(AxisBox::new([1.0, 2.0], [0.0, -0.0]).is_ok());
        assert_eq!(
            AxisBox::new([0.0, 0.0], [1.0, -0.25]),
            Err(SetError::NegativeHalfWidth { index: 1, half_width: -0.25 })
        );
        assert_eq!(
            AxisBox::from_corners([0.0, 2.0], [1.0, 1.0]),
            Err(SetError::CrossedCorners { index: 1, lower: 2.0, upper: 1.0 })
        );
        assert!(matches!(
            AxisBox::new([0.0, 0.0], [f64::NAN, 1.0]),
            Err(SetError::NonFiniteCoordinate { what: "the vector of half-widths", index: 0, .. })
        ));
        assert_eq!(
            AxisBox::new([0.0, f64::MAX], [1.0, f64::MAX]),
            Err(SetError::NonFiniteCoordinate {
                what: "the upper corner",
                index: 1,
                value: f64::INFINITY
            })
        );
    }
}
