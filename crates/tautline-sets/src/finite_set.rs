//! Finitely many points.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

use crate::closed_set::closed_set_by;
use crate::{ClosedSet, Point, SetError, Union};

/// The set `{p₁, …, pₖ}`. `P(x)` is the nearest of the points, and the first of them on a tie;
/// `DP = 0`.
///
/// Its pieces are its points, in the given order. A minimal geodesic need not end at the point that
/// is nearest in the Euclidean sense, so each one is searched.
#[derive(Clone, Debug)]
pub struct FiniteSet<const D: usize> {
    points: Union<D>,
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
        let mut members: Vec<Arc<dyn ClosedSet<D>>> = Vec::new();
        for point in points {
            members.push(Arc::new(Point::new(point)?));
        }
        Ok(FiniteSet { points: Union::new(members)? })
    }
}

impl<const D: usize> ClosedSet<D> for FiniteSet<D> {
    closed_set_by!(self => self.points);
}

#[cfg(test)]
mod tests {
    use super::FiniteSet;
    use crate::exact::contains;
    use crate::laws::{Case, check, scale, vector_in};
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
