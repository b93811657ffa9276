//! `Ends`: the two sets between which a curve runs.

use std::sync::Arc;

use nalgebra::SVector;

use crate::closed_set::append_pieces;
use crate::{AnyEnds, ClosedSet, Point, SetError};

/// The two closed sets between which a curve runs.
///
/// Invariant: at least one of them is bounded (Proposition 7.1). Neither is empty, as far as
/// probing their nearest-point maps shows. [`Ends::new`] is the only constructor.
#[derive(Clone, Debug)]
pub struct Ends<const D: usize> {
    first: Arc<dyn ClosedSet<D>>,
    second: Arc<dyn ClosedSet<D>>,
    points: bool,
}

impl<const D: usize> Ends<D> {
    /// Returns the pair for curves that start in `first` and stop in `second`.
    ///
    /// The sets may touch or overlap. The distance is then 0, see
    /// [`common_point`](crate::common_point()).
    ///
    /// # Errors
    ///
    /// - [`SetError::BothUnbounded`] if both sets are unbounded;
    /// - [`SetError::NoNearestPoint`] if a set, or one of its pieces, maps the origin or a unit
    ///   vector `±eᵢ` to a point that is not finite. An empty set does so by the contract of
    ///   [`ClosedSet`]; the sets of this crate never do.
    pub fn new(
        first: impl ClosedSet<D> + 'static,
        second: impl ClosedSet<D> + 'static,
    ) -> Result<Ends<D>, SetError> {
        let ends = Ends::of_sets(Arc::new(first), Arc::new(second), false);
        let AnyEnds { first, second, .. } = ends.in_any();
        AnyEnds::new(first, second)?;
        Ok(ends)
    }

    pub(crate) fn of_sets(
        first: Arc<dyn ClosedSet<D>>,
        second: Arc<dyn ClosedSet<D>>,
        points: bool,
    ) -> Self {
        Ends { first, second, points }
    }

    /// Returns the same pair in a dimension that is a value.
    #[must_use]
    pub fn in_any(&self) -> AnyEnds {
        let [first, second] = [&self.first, &self.second].map(|set| Arc::new(Arc::clone(set)));
        AnyEnds::of_sets(first, second, self.points)
    }

    /// Makes the pair of ends from two points with coordinates in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite.
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

    /// Returns whether the pair was made by [`Ends::points`], so that both ends of a curve are
    /// fixed. Other sets that have a single member are not recognised.
    #[must_use]
    pub fn are_points(&self) -> bool {
        self.points
    }

    /// Returns all pairs of a piece of the first set and a piece of the second.
    ///
    /// The order is fixed: the piece of the second set varies faster, and the pieces of each set
    /// keep their order. A set without pieces is its own piece; nested unions are flattened.
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::Ends;
    use crate::laws::Bare;
    use crate::numerics::norm::on_axis;
    use crate::{AffineSubspace, Ball, ClosedSet, FiniteSet, HalfSpace, Point, SetError, Union};
    use nalgebra::{SVector, vector};

    fn wall() -> HalfSpace<2> {
        HalfSpace::new([-1.0, 0.0], -2.0).expect("a normal")
    }

    #[test]
    fn ends_need_one_bounded_set() {
        let line = AffineSubspace::new([0.0, 0.0], [[0.0, 1.0]]).expect("one direction");
        assert_eq!(Ends::new(wall(), line).unwrap_err(), SetError::BothUnbounded);
        let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
        assert!(Ends::new(ball.clone(), wall()).is_ok());
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
        assert!(!Ends::new(ball.clone(), ball).expect("bounded").are_points());
        assert!(matches!(
            Ends::points([1.0, f64::NAN], [3.0, 4.0]),
            Err(SetError::NonFiniteCoordinate { index: 1, .. })
        ));
    }

    #[test]
    fn ends_refuse_an_empty_custom_set() {
        let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
        let nothing = || {
            let project = |_: &SVector<f64, 2>| vector![0.0, f64::NAN];
            Bare { project, radius: Some(0.0) }
        };
        let refused = |ends: Result<Ends<2>, SetError>, which: &str| {
            matches!(
                ends,
                Err(SetError::NoNearestPoint { end, index: 1, value }) if end == which && value.is_nan()
            )
        };
        assert!(refused(Ends::new(nothing(), ball.clone()), "first"));
        assert!(refused(Ends::new(ball.clone(), nothing()), "second"));
        // A union is refused too if the ball in it is nearest.
        let union = Union::new(vec![Arc::new(ball.clone()), Arc::new(nothing())]).expect("two");
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

    #[test]
    fn a_radius_that_is_not_finite_bounds_nothing() {
        for radius in [f64::NAN, f64::INFINITY] {
            let project = |_: &SVector<f64, 2>| SVector::zeros();
            let ends = Ends::new(Bare { project, radius: Some(radius) }, wall());
            assert_eq!(ends.unwrap_err(), SetError::BothUnbounded);
        }
    }

    /// The probes are the origin and the unit steps along every axis, in both directions, for
    /// either end.
    #[test]
    fn every_documented_probe_is_made() {
        let point = Point::new([0.0; 3]).expect("finite");
        let steps = (0..3).flat_map(|i| [1.0, -1.0].map(|sign| on_axis::<3>(i, sign)));
        for place in steps.chain([SVector::zeros()]) {
            let hole = || {
                let project = move |x: &SVector<f64, 3>| {
                    if *x == place {
                        vector![1.0, f64::INFINITY, f64::NAN]
                    } else {
                        SVector::zeros()
                    }
                };
                Bare { project, radius: Some(0.0) }
            };
            let refused = |end| SetError::NoNearestPoint { end, index: 1, value: f64::INFINITY };
            let first = Ends::new(hole(), point.clone()).expect_err("a hole");
            assert_eq!(first, refused("first"), "{place:?}");
            let second = Ends::new(point.clone(), hole()).expect_err("a hole");
            assert_eq!(second, refused("second"), "{place:?}");
        }
    }

    #[test]
    fn a_nearest_point_that_is_missing_on_one_side_only_is_found() {
        let project = |x: &SVector<f64, 2>| vector![if x[1] < 0.0 { f64::NAN } else { 0.0 }, 0.0];
        let ends = Ends::new(Bare { project, radius: Some(0.0) }, wall());
        assert!(matches!(ends, Err(SetError::NoNearestPoint { end: "first", index: 0, .. })));
    }
}
