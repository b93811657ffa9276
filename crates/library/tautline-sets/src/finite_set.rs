//! Finitely many points.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::union::Pieces;
use crate::{AnySet, ClosedSet, Point, SetError, Shape};

/// The set `{p₁, …, pₖ}`. `P(x)` is the nearest of the points, and the first of them on a tie;
/// `DP = 0`.
///
/// Its pieces are its points, in the given order. A minimal geodesic need not end at the point that
/// is nearest in the Euclidean sense, so each one is searched.
#[derive(Clone, Debug, PartialEq)]
pub struct FiniteSet<const D: usize> {
    /// The points, of which there is at least one.
    points: Vec<Point<D>>,
}

impl<const D: usize> FiniteSet<D> {
    /// Returns the set of `points`, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::Empty`] if there are no points; [`SetError::NonFiniteCoordinate`] if a
    /// coordinate is not finite.
    pub fn new<V: Into<SVector<f64, D>>>(
        points: impl IntoIterator<Item = V>,
    ) -> Result<FiniteSet<D>, SetError> {
        FiniteSet::from_slices(points.into_iter().map(|x| -> SVector<f64, D> { x.into() }))
    }

    /// Returns the set of the points with these coordinates, in `ℓ`.
    ///
    /// # Errors
    ///
    /// As for [`FiniteSet::new`]; also [`SetError::Coordinates`] if a point has not `D` coordinates, or
    /// not as many as the first.
    pub fn from_slices(
        points: impl IntoIterator<Item = impl AsRef<[f64]>>,
    ) -> Result<FiniteSet<D>, SetError> {
        let points: Vec<Point<D>> = points
            .into_iter()
            .map(|point| Point::from_slice(point.as_ref()))
            .collect::<Result<_, _>>()?;
        let dimension = points.first().ok_or(SetError::Empty)?.dimension();
        match points.iter().find(|point| point.dimension() != dimension) {
            Some(other) => Err(SetError::Coordinates {
                what: "the point",
                found: other.dimension(),
                dimension,
            }),
            None => Ok(FiniteSet { points }),
        }
    }

    /// Returns the points.
    #[must_use]
    pub fn points(&self) -> &[Point<D>] {
        &self.points
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "points",
        name: "a finite set",
        about: "Finitely many points: `points = [[0, 0], [1, 2]]`.",
        parts: &[Part::vectors("points", "The points.")],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vectors(points)] = values else { return None };
        Some(FiniteSet::from_slices(points))
    }

    pub(crate) fn cast<const E: usize>(self) -> FiniteSet<E> {
        FiniteSet { points: self.points.into_iter().map(Point::cast).collect() }
    }
}

impl<const D: usize> AnySet for FiniteSet<D> {
    fn dimension(&self) -> usize {
        self.points[0].dimension()
    }

    fn project(&self, x: &mut [f64]) {
        Pieces(|| self.points.iter()).project(x);
    }

    fn projection_derivative(&self, _x: &[f64], derivative: &mut [f64]) {
        derivative.fill(0.0);
    }

    fn radius(&self) -> Option<f64> {
        Pieces(|| self.points.iter()).radius()
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        Pieces(|| self.points.iter()).enclosing_ball()
    }

    fn is_convex(&self) -> bool {
        self.points.len() == 1
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        Pieces(|| self.points.iter()).member_near(x)
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::FiniteSet(self.clone().cast()))
    }

    fn pieces(&self) -> Vec<Arc<dyn AnySet>> {
        let piece = |point: &Point<D>| Arc::new(point.clone().cast::<ANY>()) as Arc<dyn AnySet>;
        self.points.iter().map(piece).collect()
    }
}

impl<const D: usize> Piece for FiniteSet<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        vec![Value::Vectors(self.points.iter().map(|x| x.position_slice().to_vec()).collect())]
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        self.points.iter().flat_map(Piece::boxes).collect()
    }

    fn has(&self, x: &[f64]) -> bool {
        self.points.iter().any(|point| point.has(x))
    }
}

impl<const D: usize> ClosedSet<D> for FiniteSet<D> {
    closed_set_in_any!(self => Shape::FiniteSet(self.clone()));

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        let piece = |point: &Point<D>| Arc::new(point.clone()) as Arc<dyn ClosedSet<D>>;
        self.points.iter().map(piece).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::FiniteSet;
    use crate::laws::{Case, check, scale, vector_in};
    use crate::numerics::exact::contains;
    use crate::{ClosedSet, SetError};
    use nalgebra::{SVector, vector};
    use proptest::prelude::*;

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let points = proptest::collection::vec(vector_in::<D>(3.0), 1..5);
        (points, scale()).prop_map(|(points, scale)| {
            let set = FiniteSet::new(points.iter().map(|p| p * scale)).expect("finite");
            let distances = move |x: &SVector<f64, D>, points: &[SVector<f64, D>]| {
                let mut distances: Vec<f64> = points.iter().map(|p| (x - p).norm()).collect();
                distances.sort_by(f64::total_cmp);
                distances
            };
            let [a, b, c, d] = std::array::from_fn(|_| points.clone());
            Case {
                member: Box::new(move |w| a[((w[0] + 1.0) / 2.0 * a.len() as f64) as usize]),
                defect: Box::new(move |x| distances(x, &b)[0]),
                held: Box::new(move |y| d.iter().any(|p| contains(y, p))),
                // Each distance changes by at most the length that x moves, so there is no tie
                // within half the difference.
                kink: Box::new(move |x| {
                    let d = distances(x, &c);
                    if d.len() == 1 { f64::INFINITY } else { (d[1] - d[0]) / 2.0 }
                }),
                farthest: points.iter().copied().max_by(|p, q| p.norm().total_cmp(&q.norm())),
                set: Box::new(set),
                scale,
            }
        })
    }

    #[test]
    fn finite_set_obeys_the_laws() {
        check(case::<1>());
        check(case::<3>());
    }

    #[test]
    fn finite_set_takes_the_first_on_a_tie_and_keeps_the_order() {
        let set = FiniteSet::new([[1.0, 0.0], [-1.0, 0.0], [0.0, 9.0]]).expect("finite");
        assert_eq!(set.project(&vector![0.0, 0.0]), vector![1.0, 0.0]);
        let pieces: Vec<_> = set.pieces().iter().map(|p| p.project(&vector![0.0, 0.0])).collect();
        assert_eq!(pieces, [vector![1.0, 0.0], vector![-1.0, 0.0], vector![0.0, 9.0]]);
        assert!(!set.is_convex());
    }

    #[test]
    fn finite_set_refuses_no_points_and_an_infinite_one() {
        let none: [[f64; 2]; 0] = [];
        assert_eq!(FiniteSet::new(none).unwrap_err(), SetError::Empty);
        let infinite = [[0.0, 0.0], [f64::INFINITY, 0.0]];
        assert_eq!(
            FiniteSet::new(infinite).unwrap_err(),
            SetError::NonFiniteCoordinate { what: "the point", index: 0, value: f64::INFINITY }
        );
    }
}
