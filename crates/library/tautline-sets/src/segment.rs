//! A line segment.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::numerics::norm::{between, norm_above, polar};
use crate::numerics::place::{dot, minus, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite, finite_vector, known};
use crate::{AnySet, ClosedSet, Shape};

/// The segment from `a` to `b`. With `L = |b − a|`, `v = (b − a)/L` and `s = v·(x − a)`:
///
/// ```text
/// P(x) = a + min(max(s, 0), L) v,    DP(x) = vvᵀ if 0 ≤ s ≤ L, else 0
/// ```
///
/// `a = b` is allowed; then `P = a` and `DP = 0`. Beyond an end of the segment, the projection is
/// exactly that end.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment<const D: usize> {
    start: Box<[f64]>,
    end: Box<[f64]>,
    /// The direction `v`; zero if `a = b`.
    direction: Box<[f64]>,
    /// The length `L = v·(b − a)`. It is computed by the same operations as the `s` of a point, so
    /// that `s = L` to the last bit at `b`, and the end belongs to the segment.
    length: f64,
}

impl<const D: usize> Segment<D> {
    /// Returns the segment between two points, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite; [`SetError::NonFinite`] if
    /// the length overflows.
    pub fn new(
        start: impl Into<SVector<f64, D>>,
        end: impl Into<SVector<f64, D>>,
    ) -> Result<Segment<D>, SetError> {
        Segment::from_slices(start.into().as_slice(), end.into().as_slice())
    }

    /// Returns the segment between the points with these coordinates, in `ℓ`.
    ///
    /// # Errors
    ///
    /// As for [`Segment::new`]; also [`SetError::Coordinates`] if an end has not `D` coordinates, or not
    /// as many as the other.
    pub fn from_slices(start: &[f64], end: &[f64]) -> Result<Segment<D>, SetError> {
        let start = finite_vector("the start of the segment", start, known(D))?;
        let end = finite_vector("the end of the segment", end, Some(start.len()))?;
        let chord = minus(&end, &start);
        let (length, direction) =
            polar(&chord).unwrap_or_else(|| (0.0, chord.iter().map(|_| 0.0).collect()));
        finite("length of the segment", length)?;
        let length = dot(&direction, &chord);
        Ok(Segment { start, end, direction: direction.as_slice().into(), length })
    }

    /// Returns `a`, in `ℓ`.
    #[must_use]
    pub fn start(&self) -> &SVector<f64, D> {
        vector(&self.start)
    }

    /// Returns `b`, in `ℓ`.
    #[must_use]
    pub fn end(&self) -> &SVector<f64, D> {
        vector(&self.end)
    }

    /// Returns the coordinates of `a` and `b`, in `ℓ`.
    #[must_use]
    pub fn end_slices(&self) -> [&[f64]; 2] {
        [&self.start, &self.end]
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "segment",
        name: "a segment",
        about: "The segment between two points.",
        parts: &[Part::vector("from", "One end."), Part::vector("to", "The other end.")],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(start), Value::Vector(end)] = values else { return None };
        Some(Segment::from_slices(start, end))
    }

    pub(crate) fn cast<const E: usize>(self) -> Segment<E> {
        let Self { start, end, direction, length } = self;
        Segment { start, end, direction, length }
    }

    /// Returns `s`.
    fn along(&self, x: &[f64]) -> f64 {
        dot(&self.direction, &minus(x, &self.start))
    }
}

impl<const D: usize> AnySet for Segment<D> {
    fn dimension(&self) -> usize {
        self.start.len()
    }

    fn project(&self, x: &mut [f64]) {
        let s = self.along(x);
        if s <= 0.0 {
            x.copy_from_slice(&self.start);
        } else if s >= self.length {
            x.copy_from_slice(&self.end);
        } else {
            let pairs = self.start.iter().zip(&self.direction);
            x.iter_mut().zip(pairs).for_each(|(x, (a, v))| *x = a + v * s);
        }
    }

    fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        let s = self.along(x);
        if !(0.0 <= s && s <= self.length) {
            return derivative.fill(0.0);
        }
        let products =
            self.direction.iter().flat_map(|v| self.direction.iter().map(move |u| u * v));
        derivative.iter_mut().zip(products).for_each(|(to, product)| *to = product);
    }

    fn radius(&self) -> Option<f64> {
        let ends = [&self.start, &self.end].map(|end| norm_above(&proof::point(end)));
        Some(ends[0].max(ends[1]))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        // The ends are halved first, since their sum may overflow.
        let pairs = self.start.iter().zip(&self.end);
        let centre: Vec<f64> = pairs.map(|(a, b)| a * 0.5 + b * 0.5).collect();
        let ends = [&self.start, &self.end].map(|end| norm_above(&between(end, &centre)));
        Some((centre, ends[0].max(ends[1])))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let pairs = || self.start.iter().zip(&self.end);
        // A segment along an axis is a flat box, for which clamping does not round.
        if pairs().filter(|(a, b)| a != b).count() <= 1 {
            let clamped = x.iter().zip(pairs()).map(|(x, (&a, &b))| x.clamp(a.min(b), a.max(b)));
            return Some(clamped.map(Interval::point).collect());
        }
        let s = self.along(x);
        if s <= 0.0 {
            return Some(proof::point(&self.start));
        }
        // Any s in [0, L] gives a member: rounding s moves the member along the segment.
        let fraction = s / self.length;
        if !(fraction < 1.0) {
            return (fraction >= 1.0).then(|| proof::point(&self.end));
        }
        let ends = pairs().map(|(&a, &b)| (Interval::point(a), Interval::point(b)));
        proof::finite(ends.map(|(a, b)| a + (b - a) * fraction).collect())
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::Segment(self.clone().cast()))
    }
}

impl<const D: usize> Piece for Segment<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        self.end_slices().map(|end| Value::Vector(end.to_vec())).to_vec()
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        {
            let corner = |of: fn(f64, f64) -> f64| {
                self.start.iter().zip(&self.end).map(|(&a, &b)| of(a, b)).collect()
            };
            vec![[corner(f64::min), corner(f64::max)]]
        }
    }
}

impl<const D: usize> ClosedSet<D> for Segment<D> {
    closed_set_in_any!(self => Shape::Segment(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::Segment;
    use crate::laws::{Case, check, check_edges, scale, vector_in};
    use crate::numerics::exact::{difference, meets_line};
    use crate::{ClosedSet, SetError};
    use nalgebra::{Matrix2, SVector, vector};
    use proptest::prelude::*;
    use tautline_scalar::Interval;

    /// Tests membership without the projection formula: `|x − a| + |x − b| = L` holds on the
    /// segment alone.
    ///
    /// At a distance `δ` from the segment the sum exceeds `L` only by `2δ²/L`. Therefore the
    /// distance to the line, which is the component orthogonal to `b − a`, counts too.
    fn defect<const D: usize>(a: SVector<f64, D>, b: SVector<f64, D>, x: &SVector<f64, D>) -> f64 {
        let (length, past) = ((b - a).norm(), (x - a).norm() + (x - b).norm());
        if length == 0.0 {
            return past;
        }
        let line = a.lerp(&b, (x - a).norm() / length);
        (x - line).norm().max(past - length)
    }

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let ends = prop_oneof![
            4 => (vector_in::<D>(3.0), vector_in::<D>(3.0)),
            1 => vector_in::<D>(3.0).prop_map(|a| (a, a)),
        ];
        (ends, scale()).prop_map(|((a, b), scale)| Case {
            member: Box::new(move |w| a.lerp(&b, (w[0] + 1.0) / 2.0)),
            defect: Box::new(move |x| defect(a, b, x)),
            held: Box::new(move |y| meets_line(y, &a, &difference(&b, &a), true)),
            // The kinks are the planes through the ends, orthogonal to b − a.
            kink: Box::new(move |x| match (b - a).try_normalize(0.0) {
                Some(v) => v.dot(&(x - a)).abs().min(v.dot(&(x - b)).abs()),
                None => f64::INFINITY,
            }),
            farthest: Some(if a.norm() > b.norm() { a } else { b }),
            set: Box::new(Segment::new(a * scale, b * scale).expect("finite")),
            scale,
        })
    }

    #[test]
    fn segment_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<4>());
    }

    #[test]
    fn the_ends_of_a_segment_belong_to_it() {
        check_edges(case::<1>());
        check_edges(case::<2>());
        check_edges(case::<4>());
    }

    #[test]
    fn segment_ends_are_met_exactly_and_count_as_inside() {
        let (a, b) = (vector![0.1, 0.2], vector![0.7, -0.4]);
        let segment = Segment::new(a, b).expect("finite");
        assert_eq!(segment.project(&vector![-5.0, 5.0]), a);
        assert_eq!(segment.project(&vector![5.0, -5.0]), b);
        assert_ne!(segment.projection_derivative(&a), Matrix2::zeros());
        assert_ne!(segment.projection_derivative(&b), Matrix2::zeros());
        assert_eq!(segment.projection_derivative(&vector![5.0, -5.0]), Matrix2::zeros());
    }

    #[test]
    fn segment_of_length_zero_is_a_point() {
        let point = Segment::new([1.0, 2.0], [1.0, 2.0]).expect("closed");
        assert_eq!(point.project(&vector![7.0, 7.0]), vector![1.0, 2.0]);
        assert_eq!(point.projection_derivative(&vector![1.0, 2.0]), Matrix2::zeros());
    }

    /// The offset overflows, and `s` is unknown. The segment must not return an end instead.
    #[test]
    fn segment_proves_nothing_beyond_f64() {
        let low = Segment::new([0.0, 0.0, -f64::MAX], [3.0, 4.0, -f64::MAX]).expect("length 5");
        assert_eq!(low.member_near(&vector![0.0, 0.0, f64::MAX]), None);
        let end = low.member_near(&vector![30.0, 40.0, 0.0]).expect("past the end");
        assert_eq!(end, low.end().map(Interval::point));
    }

    #[test]
    fn segment_refuses_a_bad_end_and_a_length_beyond_f64() {
        assert!(matches!(
            Segment::new([0.0, 0.0], [0.0, f64::NAN]),
            Err(SetError::NonFiniteCoordinate { what: "the end of the segment", index: 1, .. })
        ));
        assert_eq!(
            Segment::new([-f64::MAX], [f64::MAX]),
            Err(SetError::NonFinite { what: "length of the segment", value: f64::INFINITY })
        );
    }
}
