//! `Ends`: the two sets between which a curve runs.

use std::sync::Arc;

use nalgebra::SVector;

use crate::closed_set::append_pieces;
use crate::norm::on_axis;
use crate::set_error::non_finite;
use crate::{ClosedSet, Point, SetError};

/// The two closed sets between which a curve runs.
///
/// Invariant: one of them at least is bounded (Proposition 7.1), and neither is empty as far as
/// probes of its nearest-point map can tell. [`Ends::new`] is the only way in.
#[derive(Clone, Debug)]
pub struct Ends<const D: usize> {
    first: Arc<dyn ClosedSet<D>>,
    second: Arc<dyn ClosedSet<D>>,
    points: bool,
}

impl<const D: usize> Ends<D> {
    /// Makes the pair: curves start in `first` and stop in `second`.
    ///
    /// The sets may touch or overlap; the distance is 0 then, see
    /// [`common_point`](crate::common_point()).
    ///
    /// # Errors
    ///
    /// - [`SetError::BothUnbounded`];
    /// - [`SetError::NoNearestPoint`] if a set, or one of its pieces, sends the origin or a unit
    ///   vector `±eᵢ` to a point that is not finite. An empty set does, if it is written as
    ///   [`ClosedSet`] asks for; the sets of this crate never do.
    pub fn new(
        first: impl ClosedSet<D> + 'static,
        second: impl ClosedSet<D> + 'static,
    ) -> Result<Ends<D>, SetError> {
        let ends = Ends { first: Arc::new(first), second: Arc::new(second), points: false };
        probe("first", &ends.first)?;
        probe("second", &ends.second)?;
        // A radius of NaN or ∞ bounds nothing.
        let bounded = |set: &dyn ClosedSet<D>| set.radius().is_some_and(f64::is_finite);
        if !(bounded(&*ends.first) || bounded(&*ends.second)) {
            return Err(SetError::BothUnbounded);
        }
        Ok(ends)
    }

    /// Makes the pair of two points, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`].
    pub fn points(
        first: impl Into<SVector<f64, D>>,
        second: impl Into<SVector<f64, D>>,
    ) -> Result<Ends<D>, SetError> {
        Ok(Ends { points: true, ..Ends::new(Point::new(first)?, Point::new(second)?)? })
    }

    /// Returns the set in which curves start.
    #[must_use]
    pub fn first(&self) -> &Arc<dyn ClosedSet<D>> {
        &self.first
    }

    /// Returns the set in which curves stop.
    #[must_use]
    pub fn second(&self) -> &Arc<dyn ClosedSet<D>> {
        &self.second
    }

    /// Returns whether the pair was made by [`Ends::points`]: then both ends of a curve are fixed.
    /// Of sets that happen to have one member each it is not known.
    #[must_use]
    pub fn are_points(&self) -> bool {
        self.points
    }

    /// Returns all pairs of a piece of the first set and a piece of the second.
    ///
    /// The order is fixed: the second varies faster, and each set's pieces come in its own
    /// order. A set which is one piece counts as its own piece; unions within unions are
    /// dissolved.
    pub fn pairs(
        &self,
    ) -> impl Iterator<Item = (Arc<dyn ClosedSet<D>>, Arc<dyn ClosedSet<D>>)> + use<D> {
        let (mut firsts, mut seconds) = (Vec::new(), Vec::new());
        append_pieces(&self.first, &mut firsts);
        append_pieces(&self.second, &mut seconds);
        firsts.into_iter().flat_map(move |first| {
            seconds.clone().into_iter().map(move |second| (Arc::clone(&first), second))
        })
    }
}

/// Projects a few points to `set` and to its pieces, and refuses results that are not finite.
fn probe<const D: usize>(end: &'static str, set: &Arc<dyn ClosedSet<D>>) -> Result<(), SetError> {
    let mut pieces = vec![Arc::clone(set)];
    append_pieces(set, &mut pieces);
    let units = (0..D).flat_map(|i| [1.0, -1.0].map(|sign| on_axis(i, sign)));
    for x in std::iter::once(SVector::zeros()).chain(units) {
        for piece in &pieces {
            if let Some((index, value)) = non_finite(&piece.project(&x)) {
                return Err(SetError::NoNearestPoint { end, index, value });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::Ends;
    use crate::norm::on_axis;
    use crate::{AffineSubspace, Ball, ClosedSet, FiniteSet, HalfSpace, Point, SetError, Union};
    use nalgebra::{SMatrix, SVector, vector};

    fn wall() -> HalfSpace<2> {
        HalfSpace::new([-1.0, 0.0], -2.0).expect("a normal")
    }

    #[test]
    fn ends_want_one_bounded_set() {
        let line = AffineSubspace::new([0.0, 0.0], [[0.0, 1.0]]).expect("one direction");
        assert_eq!(Ends::new(wall(), line).unwrap_err(), SetError::BothUnbounded);
        let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
        assert!(Ends::new(ball, wall()).is_ok());
        assert!(Ends::new(wall(), ball).is_ok());
    }

    #[test]
    fn ends_may_touch() {
        let ball = Ball::new([0.0, 0.0], 2.0).expect("finite");
        assert!(Ends::new(ball, wall()).is_ok());
        assert!(Ends::points([1.0, 1.0], [1.0, 1.0]).is_ok());
    }

    #[test]
    fn ends_of_points_are_the_points() {
        let ends = Ends::points([1.0, 2.0], [3.0, 4.0]).expect("finite");
        let x = vector![0.0, 0.0];
        assert_eq!(ends.first().project(&x), vector![1.0, 2.0]);
        assert_eq!(ends.second().project(&x), vector![3.0, 4.0]);
        assert!(ends.are_points());
        let ball = Ball::new([0.0, 0.0], 2.0).expect("finite");
        assert!(!Ends::new(ball, ball).expect("bounded").are_points());
        assert!(matches!(
            Ends::points([1.0, f64::NAN], [3.0, 4.0]),
            Err(SetError::NonFiniteCoordinate { index: 1, .. })
        ));
    }

    /// A set of the user's own, without members.
    #[derive(Debug)]
    struct Nothing;

    impl ClosedSet<2> for Nothing {
        fn project(&self, _x: &SVector<f64, 2>) -> SVector<f64, 2> {
            vector![0.0, f64::NAN]
        }

        fn projection_derivative(&self, _x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }

        fn radius(&self) -> Option<f64> {
            Some(0.0)
        }
    }

    #[test]
    fn ends_refuse_an_empty_set_of_the_users_own() {
        let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
        let refused = |ends: Result<Ends<2>, SetError>, which: &str| {
            matches!(
                ends,
                Err(SetError::NoNearestPoint { end, index: 1, value }) if end == which && value.is_nan()
            )
        };
        assert!(refused(Ends::new(Nothing, ball), "first"));
        assert!(refused(Ends::new(ball, Nothing), "second"));
        // Hidden in a union, where the ball is the nearest: found all the same.
        let union = Union::new(vec![Arc::new(ball), Arc::new(Nothing)]).expect("two");
        assert!(refused(Ends::new(ball, union), "second"));
    }

    #[test]
    fn ends_pairs_come_in_a_fixed_order() {
        let two = FiniteSet::new([[1.0], [2.0]]).expect("finite");
        let three: Vec<Arc<dyn ClosedSet<1>>> = vec![
            Arc::new(FiniteSet::new([[10.0], [20.0]]).expect("finite")),
            Arc::new(Point::new([30.0]).expect("finite")),
        ];
        let ends = Ends::new(two, Union::new(three).expect("two members")).expect("bounded");
        let at = |set: &Arc<dyn ClosedSet<1>>| set.project(&vector![0.0])[0];
        let pairs: Vec<(f64, f64)> = ends.pairs().map(|(a, b)| (at(&a), at(&b))).collect();
        let expected =
            [(1.0, 10.0), (1.0, 20.0), (1.0, 30.0), (2.0, 10.0), (2.0, 20.0), (2.0, 30.0)];
        assert_eq!(pairs, expected);
        let single = Ends::points([1.0], [2.0]).expect("finite");
        assert_eq!(single.pairs().count(), 1);
    }

    #[test]
    fn ends_take_a_set_chosen_at_run_time() {
        let set: Arc<dyn ClosedSet<2>> = Arc::new(wall());
        let ends = Ends::new(set, Point::new([0.0, 0.0]).expect("finite")).expect("one bounded");
        assert_eq!(ends.clone().first().project(&vector![0.0, 1.0]), vector![2.0, 1.0]);
    }

    /// A set that lies about its radius, or about the nearest points of one side.
    #[derive(Debug)]
    struct Wrong {
        radius: f64,
        below: f64,
    }

    impl ClosedSet<2> for Wrong {
        fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
            if x[1] < 0.0 { vector![self.below, 0.0] } else { vector![0.0, 0.0] }
        }

        fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }

        fn radius(&self) -> Option<f64> {
            Some(self.radius)
        }
    }

    #[test]
    fn a_radius_that_is_not_finite_bounds_nothing() {
        for radius in [f64::NAN, f64::INFINITY] {
            let ends = Ends::new(Wrong { radius, below: 0.0 }, wall());
            assert_eq!(ends.unwrap_err(), SetError::BothUnbounded);
        }
    }

    /// A set that has a nearest point to all places but one.
    #[derive(Clone, Debug)]
    struct Hole(SVector<f64, 3>);

    impl ClosedSet<3> for Hole {
        fn project(&self, x: &SVector<f64, 3>) -> SVector<f64, 3> {
            if *x == self.0 { vector![1.0, f64::INFINITY, f64::NAN] } else { SVector::zeros() }
        }

        fn projection_derivative(&self, _: &SVector<f64, 3>) -> SMatrix<f64, 3, 3> {
            SMatrix::zeros()
        }

        fn radius(&self) -> Option<f64> {
            Some(0.0)
        }
    }

    /// The origin, and one step from it along every axis, both ways: of either end.
    #[test]
    fn every_place_that_is_said_to_be_tried_is_tried() {
        let point = Point::new([0.0; 3]).expect("finite");
        let steps = (0..3).flat_map(|i| [1.0, -1.0].map(|sign| on_axis(i, sign)));
        for place in steps.chain([SVector::zeros()]) {
            let refused = |end| SetError::NoNearestPoint { end, index: 1, value: f64::INFINITY };
            let first = Ends::new(Hole(place), point).expect_err("a hole");
            assert_eq!(first, refused("first"), "{place:?}");
            let second = Ends::new(point, Hole(place)).expect_err("a hole");
            assert_eq!(second, refused("second"), "{place:?}");
        }
    }

    #[test]
    fn a_nearest_point_that_is_missing_on_one_side_only_is_found() {
        let ends = Ends::new(Wrong { radius: 0.0, below: f64::NAN }, wall());
        assert!(matches!(ends, Err(SetError::NoNearestPoint { end: "first", index: 0, .. })));
    }
}
