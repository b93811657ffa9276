//! A finite union of closed sets.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

use crate::closed_set::append_pieces;
use crate::numerics::norm::{between, norm, norm_above, sum_above};
use crate::numerics::place::{Place, add, minus};
use crate::{AnySet, ClosedSet, InAny, SetError, Shape};

/// The union of finitely many closed sets.
///
/// `P(x)` and `DP(x)` are those of the member nearest to `x`, and of the first such member on a
/// tie. Nested unions are flattened in order, so that no piece has pieces itself.
#[derive(Clone, Debug)]
pub struct Union<const D: usize> {
    /// The pieces, of which there is at least one.
    pieces: Vec<Arc<dyn ClosedSet<D>>>,
}

impl<const D: usize> Union<D> {
    /// Returns the union of `members`.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use nalgebra::vector;
    /// # use tautline_sets::{AxisBox, Ball, ClosedSet, SetError, Union};
    /// let ball = Ball::new([0.0, 0.0], 1.0)?;
    /// let wall = AxisBox::from_corners([2.0, -9.0], [3.0, 9.0])?;
    /// let either = Union::new(vec![Arc::new(ball), Arc::new(wall)])?;
    /// assert_eq!(either.project(&vector![1.75, 0.0]), vector![2.0, 0.0]);
    /// # Ok::<(), SetError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SetError::Empty`] if there are no members.
    pub fn new(members: Vec<Arc<dyn ClosedSet<D>>>) -> Result<Union<D>, SetError> {
        let mut pieces = Vec::new();
        for member in &members {
            append_pieces(member, &mut pieces);
        }
        if pieces.is_empty() { Err(SetError::Empty) } else { Ok(Union { pieces }) }
    }

    /// Returns the pieces as sets of a space whose dimension is a value, one after the other.
    fn in_any(&self) -> impl Iterator<Item = InAny<'_, D>> {
        self.pieces.iter().map(|piece| InAny(&**piece))
    }
}

/// The union of the sets that an iterator lists.
pub(crate) struct Pieces<F>(pub(crate) F);

impl<I: Iterator<Item: AnySet>, F: Fn() -> I> Pieces<F> {
    /// Returns the point of the union nearest to `x`, and the piece that contains it; `None` if there
    /// are no pieces.
    fn nearest(&self, x: &[f64]) -> Option<(Place, I::Item)> {
        let mut nearest: Option<(f64, Place, I::Item)> = None;
        for piece in self.0() {
            let mut point = Place::from_slice(x);
            piece.project(&mut point);
            let distance = norm(&minus(&point, x));
            if nearest.as_ref().is_none_or(|(least, ..)| distance < *least) {
                nearest = Some((distance, point, piece));
            }
        }
        nearest.map(|(_, point, piece)| (point, piece))
    }

    /// Moves `x` to the nearest point; to NaN if there are no pieces.
    pub(crate) fn project(&self, x: &mut [f64]) {
        match self.nearest(x) {
            Some((point, _)) => x.copy_from_slice(&point),
            None => x.fill(f64::NAN),
        }
    }

    pub(crate) fn projection_derivative(&self, x: &[f64], derivative: &mut [f64]) {
        match self.nearest(x) {
            Some((_, piece)) => piece.projection_derivative(x, derivative),
            None => derivative.fill(f64::NAN),
        }
    }

    pub(crate) fn radius(&self) -> Option<f64> {
        let radii: Option<Vec<f64>> = self.0().map(|piece| piece.radius()).collect();
        Some(largest(radii?))
    }

    /// The ball is centred at the mean of the centres of the members.
    pub(crate) fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        let balls: Option<Vec<_>> = self.0().map(|piece| piece.enclosing_ball()).collect();
        let balls = balls?;
        let share = 1.0 / balls.len() as f64;
        let mut middle = vec![0.0; balls.first()?.0.len()];
        balls.iter().for_each(|(centre, _)| add(&mut middle, centre, share));
        let reach = |(centre, radius): &(Vec<f64>, f64)| {
            sum_above(norm_above(&between(centre, &middle)), *radius)
        };
        let radius = largest(balls.iter().map(reach));
        Some((middle, radius))
    }

    /// Returns the nearest of the boxes that the members prove. Members that prove nothing are
    /// skipped.
    pub(crate) fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let mut nearest: Option<(f64, Vec<Interval>)> = None;
        for member in self.0().filter_map(|piece| piece.member_near(x)) {
            let middle: Place = member.iter().map(|side| side.midpoint()).collect();
            let away = norm(&minus(&middle, x));
            // On a tie the first box is kept.
            if nearest.as_ref().is_none_or(|(distance, _)| away < *distance) {
                nearest = Some((away, member));
            }
        }
        nearest.map(|(_, member)| member)
    }

    /// Returns whether the only member is convex. The result is `false` for several members, which
    /// are not examined.
    pub(crate) fn is_convex(&self) -> bool {
        let mut pieces = self.0();
        pieces.next().is_some_and(|one| one.is_convex()) && pieces.next().is_none()
    }

    /// Returns the seeds of all pieces, in their order.
    pub(crate) fn seeds(&self) -> Vec<Vec<f64>> {
        self.0().flat_map(|piece| piece.seeds()).collect()
    }
}

/// Returns the largest radius. If one is NaN, the result is NaN, which bounds nothing.
fn largest(radii: impl IntoIterator<Item = f64>) -> f64 {
    radii.into_iter().fold(0.0, |a, b| if a.is_nan() || b <= a { a } else { b })
}

impl<const D: usize> ClosedSet<D> for Union<D> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        let mut nearest = *x;
        Pieces(|| self.in_any()).project(nearest.as_mut_slice());
        nearest
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        let mut derivative = SMatrix::<f64, D, D>::zeros();
        Pieces(|| self.in_any()).projection_derivative(x.as_slice(), derivative.as_mut_slice());
        derivative
    }

    fn radius(&self) -> Option<f64> {
        Pieces(|| self.in_any()).radius()
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        let (centre, radius) = Pieces(|| self.in_any()).enclosing_ball()?;
        Some((SVector::from_column_slice(&centre), radius))
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        let member = Pieces(|| self.in_any()).member_near(x.as_slice())?;
        Some(SVector::from_column_slice(&member))
    }

    fn is_convex(&self) -> bool {
        Pieces(|| self.in_any()).is_convex()
    }

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        self.pieces.clone()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        let seeds = Pieces(|| self.in_any()).seeds();
        seeds.iter().map(|x| SVector::from_column_slice(x)).collect()
    }

    fn shape(&self) -> Option<Shape<D>> {
        Shape::of_sets(&self.pieces)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::Union;
    use crate::laws::{Case, check, extent, scale, vector_in};
    use crate::numerics::exact::{square, squared_distances};
    use crate::numerics::norm::on_axis;
    use crate::{Ball, ClosedSet, FiniteSet, HalfSpace, Point, SetError, Sphere};
    use nalgebra::{SVector, vector};
    use proptest::prelude::*;
    use tautline_scalar::Interval;

    /// Returns the union of a ball and a sphere, with their formulas.
    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let parts = (vector_in::<D>(3.0), extent(), vector_in::<D>(3.0), extent());
        (parts, scale()).prop_map(|((c, r, k, s), scale)| {
            let ball = Ball::new(c * scale, r * scale).expect("finite");
            let sphere = Sphere::new(k * scale, s * scale).expect("finite");
            let to_ball = move |x: &SVector<f64, D>| ((x - c).norm() - r).max(0.0);
            let to_sphere = move |x: &SVector<f64, D>| ((x - k).norm() - s).abs();
            let outermost = |c: SVector<f64, D>, r: f64| c * (1.0 + r / c.norm());
            let (in_ball, on_sphere) = (outermost(c, r), outermost(k, s));
            Case {
                member: Box::new(move |w| {
                    if w[0] > 0.0 {
                        c + w * (r / (D as f64).sqrt())
                    } else {
                        k + w.try_normalize(0.0).unwrap_or_else(|| on_axis(0, 1.0)) * s
                    }
                }),
                defect: Box::new(move |x| to_ball(x).min(to_sphere(x))),
                held: Box::new(move |y| {
                    let (to_c, _) = squared_distances(y, &c);
                    let (least, most) = squared_distances(y, &k);
                    let on_sphere = least.at_most(&square(s)) && square(s).at_most(&most);
                    to_c.at_most(&square(r)) || on_sphere
                }),
                // Each distance changes by at most the length of the displacement of x.
                kink: Box::new(move |x| {
                    let rim = if r == 0.0 { f64::INFINITY } else { ((x - c).norm() - r).abs() };
                    let tie = (to_ball(x) - to_sphere(x)).abs() / 2.0;
                    tie.min(rim).min((x - k).norm() / 4.0)
                }),
                farthest: Some(if in_ball.norm() > on_sphere.norm() { in_ball } else { on_sphere }),
                set: Box::new(Union::new(vec![Arc::new(ball), Arc::new(sphere)]).expect("two")),
                scale,
            }
        })
    }

    #[test]
    fn union_obeys_the_laws() {
        check(case::<1>());
        check(case::<3>());
    }

    #[test]
    fn union_flattens_unions_and_keeps_the_order() {
        let points = FiniteSet::new([[1.0], [2.0]]).expect("finite");
        let inner = Union::new(vec![Arc::new(points), Arc::new(Point::new([3.0]).expect("3"))]);
        let outer = Union::new(vec![
            Arc::new(Point::new([0.0]).expect("0")),
            Arc::new(inner.expect("two")),
            Arc::new(Sphere::new([9.0], 1.0).expect("9")),
        ])
        .expect("three");
        let pieces: Vec<f64> =
            outer.pieces().iter().map(|piece| piece.project(&vector![-5.0])[0]).collect();
        assert_eq!(pieces, [0.0, 1.0, 2.0, 3.0, 8.0]);
        assert!(outer.pieces().iter().all(|piece| piece.pieces().is_empty()));
        assert_eq!(outer.seeds(), [vector![10.0], vector![8.0]]);
    }

    #[test]
    fn union_takes_the_first_on_a_tie() {
        let left = Ball::new([-2.0, 0.0], 1.0).expect("finite");
        let right = Ball::new([2.0, 0.0], 1.0).expect("finite");
        let union = Union::new(vec![Arc::new(right), Arc::new(left)]).expect("two");
        assert_eq!(union.project(&vector![0.0, 0.0]), vector![1.0, 0.0]);
    }

    #[test]
    fn union_proves_the_first_member_on_a_tie() {
        let at = |x: f64| Arc::new(Point::new([x, 0.0]).expect("finite"));
        let union = Union::new(vec![at(3.0), at(1.0), at(-1.0)]).expect("three");
        let near = union.member_near(&vector![0.0, 0.0]).expect("points");
        assert_eq!(near, vector![1.0, 0.0].map(Interval::point));
        // The Euclidean distance decides which box is nearest.
        let union = Union::new(vec![Arc::new(Point::new([0.0, 9.0]).expect("finite")), at(2.0)]);
        let near = union.expect("two").member_near(&vector![0.0, 0.0]).expect("points");
        assert_eq!(near, vector![2.0, 0.0].map(Interval::point));
    }

    #[test]
    fn union_with_an_unbounded_member_is_unbounded() {
        let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
        let wall = HalfSpace::new([1.0, 0.0], -3.0).expect("a normal");
        assert_eq!(
            Union::new(vec![Arc::new(ball.clone()), Arc::new(wall)]).expect("two").radius(),
            None
        );
        let one = Union::new(vec![Arc::new(ball)]).expect("one");
        assert_eq!(one.radius(), Some(1.0));
        assert!(one.is_convex());
        let hollow = Sphere::new([0.0, 0.0], 1.0).expect("finite");
        assert!(!Union::new(vec![Arc::new(hollow)]).expect("one").is_convex());
    }

    #[test]
    fn union_refuses_no_members() {
        assert_eq!(Union::<2>::new(Vec::new()).unwrap_err(), SetError::Empty);
    }
}
