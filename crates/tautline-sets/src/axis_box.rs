//! A box with sides parallel to the axes.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

use crate::norm::{between, norm_above};
use crate::proof;
use crate::set_error::{SetError, finite_vector};
use crate::{ClosedSet, Shape};

/// The box `lᵢ ≤ xᵢ ≤ uᵢ`.
///
/// ```text
/// P(x)ᵢ = min(max(xᵢ, lᵢ), uᵢ),    DP(x) = diag(δ),   δᵢ = 1 if lᵢ ≤ xᵢ ≤ uᵢ and lᵢ < uᵢ, else 0
/// ```
///
/// `lᵢ = uᵢ` is allowed: the box is flat in that coordinate, `P(x)ᵢ` is constant, and `δᵢ = 0`
/// everywhere. Projections lie in the box exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "crate::data::AxisBox<D>")
)]
pub struct AxisBox<const D: usize> {
    lower: SVector<f64, D>,
    upper: SVector<f64, D>,
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
        let centre = finite_vector("the centre", centre)?;
        let half_widths = finite_vector("the vector of half-widths", half_widths)?;
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
        let lower = finite_vector("the lower corner", lower)?;
        let upper = finite_vector("the upper corner", upper)?;
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
        &self.lower
    }

    /// Returns the corner `u`, in `ℓ`.
    #[must_use]
    pub fn upper(&self) -> &SVector<f64, D> {
        &self.upper
    }
}

impl<const D: usize> ClosedSet<D> for AxisBox<D> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        SVector::from_fn(|i, _| x[i].clamp(self.lower[i], self.upper[i]))
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        SMatrix::from_diagonal(&SVector::from_fn(|i, _| {
            let (lower, upper) = (self.lower[i], self.upper[i]);
            if lower < upper && lower <= x[i] && x[i] <= upper { 1.0 } else { 0.0 }
        }))
    }

    fn radius(&self) -> Option<f64> {
        let farthest = self.lower.zip_map(&self.upper, |l, u| l.abs().max(u.abs()));
        Some(norm_above(&proof::point(&farthest)))
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        let centre = self.lower * 0.5 + self.upper * 0.5;
        let sides =
            between(&self.upper, &centre).zip_map(&between(&centre, &self.lower), |u, l| {
                if u.magnitude() > l.magnitude() { u } else { l }
            });
        Some((centre, norm_above(&sides)))
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        // Clamping does not round.
        Some(proof::point(&self.project(x)))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn shape(&self) -> Option<Shape<D>> {
        Some(Shape::AxisBox(*self))
    }
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
