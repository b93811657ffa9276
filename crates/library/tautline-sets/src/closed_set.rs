//! `ClosedSet`: a non-empty closed subset of `R^D`, given by its nearest-point map.

use std::fmt::Debug;
use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

use crate::Shape;

/// A non-empty closed subset `X` of `R^D`, given by its Euclidean nearest-point map `P`.
///
/// # Laws
///
/// For finite `x`, up to rounding:
///
/// - `P(x)` lies in `X`, `P(P(x)) = P(x)`, and no member of `X` is nearer to `x` than `P(x)`;
/// - if [`is_convex`](ClosedSet::is_convex) returns true, then `|P(x) − P(y)| ≤ |x − y|`, and the
///   eigenvalues of the derivative lie in `[0, 1]`;
/// - no member of `X` is farther from the origin than [`radius`](ClosedSet::radius), or outside the
///   [`enclosing_ball`](ClosedSet::enclosing_ball);
/// - a box from [`member_near`](ClosedSet::member_near) contains a member of `X`; this law holds
///   exactly, not only up to rounding.
///
/// No method panics on finite input; none reads a clock, a file or a random number. An empty set
/// has no nearest point: an implementation that may be empty returns NaN, and
/// [`Ends::new`](crate::Ends::new) refuses it.
///
/// A set of your own may look like this strip:
///
/// ```
/// use nalgebra::{SMatrix, SVector, matrix, vector};
/// use tautline_sets::{Ball, ClosedSet, Ends};
///
/// /// `|x₂| ≤ 1`.
/// #[derive(Debug)]
/// struct Strip;
/// impl ClosedSet<2> for Strip {
///     fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
///         vector![x[0], x[1].clamp(-1.0, 1.0)]
///     }
///     fn projection_derivative(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
///         let inside = f64::from(u8::from(x[1].abs() <= 1.0));
///         matrix![1.0, 0.0; 0.0, inside]
///     }
///     fn radius(&self) -> Option<f64> {
///         None
///     }
///     fn is_convex(&self) -> bool {
///         true
///     }
/// }
///
/// let ends = Ends::new(Ball::new([0.0, 5.0], 1.0)?, Strip)?;
/// assert_eq!(ends.second().project(&vector![3.0, 5.0]), vector![3.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait ClosedSet<const D: usize>: Debug + Send + Sync {
    /// Returns a point `P(x)` of the set that is nearest to `x`, in `ℓ`.
    ///
    /// If several points are nearest, which is possible for a nonconvex set, returns one of them,
    /// always the same.
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D>;

    /// Returns an element of Clarke's generalised derivative of `P` at `x`, which is a limit of
    /// derivatives `DP(xₖ)` with `xₖ → x`. It is a symmetric matrix of pure numbers.
    ///
    /// Where `P` is smooth, this element is its derivative. It is symmetric since `P` is the
    /// gradient of `½|x|² − ½ dist(x, X)²`. At a kink the point counts as inside: if the set has an
    /// interior, the derivative is `I` on its boundary too. Where `P` jumps (`x` is equally far
    /// from two places), the element is the derivative of the branch that
    /// [`project`](ClosedSet::project) chooses.
    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D>;

    /// Returns `sup |x|` over the set, rounded up, in `ℓ`; `None` if the set is unbounded.
    fn radius(&self) -> Option<f64>;

    /// Returns the centre and the radius of a ball that contains the set, in `ℓ`; `None` if the set
    /// is unbounded.
    ///
    /// The radius is rounded up, since proofs take constants on this ball: the set that the numbers
    /// define lies in it exactly. The ball need not be the smallest: the default is a ball about the origin. Override this
    /// method for sets far from the origin, since constants are better on smaller regions.
    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        Some((SVector::zeros(), self.radius()?))
    }

    /// Returns whether the set is known to be convex. `false` claims nothing.
    ///
    /// Under a constant metric every local minimum of the distance to a convex set is global, so
    /// convex sets have no [`seeds`](ClosedSet::seeds).
    fn is_convex(&self) -> bool {
        false
    }

    /// Returns a box that certainly contains a member of the set, as near to `x` as the set can
    /// prove, in `ℓ`. The default is `None`: the set can prove nothing.
    ///
    /// The box is `[x, x]` if and only if `x` itself is proved to be a member; otherwise it is a
    /// few roundings wide and lies around `P(x)`. The member may be anywhere in the box. The set in
    /// question is defined exactly by the given numbers: rounding in its construction, for example
    /// in the length of a normal, does not enter.
    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        let _ = x;
        None
    }

    /// Returns the set as data, if it is one of the [`Shape`]s. The default is `None`. Only a set of an
    /// [elementary](Shape::into_elementary) shape can be written into a certificate.
    fn shape(&self) -> Option<Shape<D>> {
        None
    }

    /// Returns the members of a union, each of which is searched separately; empty for a single
    /// piece.
    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        Vec::new()
    }

    /// Returns further points of the set, in `ℓ`, from which a local search should start. A
    /// nonconvex set, such as a sphere, has several local solutions.
    fn seeds(&self) -> Vec<SVector<f64, D>> {
        Vec::new()
    }
}

/// Implements [`ClosedSet`] by delegating to another set.
macro_rules! closed_set_by {
    ($self:ident => $set:expr) => {
        fn project(&$self, x: &SVector<f64, D>) -> SVector<f64, D> {
            $set.project(x)
        }

        fn projection_derivative(&$self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
            $set.projection_derivative(x)
        }

        fn radius(&$self) -> Option<f64> {
            $set.radius()
        }

        fn enclosing_ball(&$self) -> Option<(SVector<f64, D>, f64)> {
            $set.enclosing_ball()
        }

        fn is_convex(&$self) -> bool {
            $set.is_convex()
        }

        fn member_near(&$self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
            $set.member_near(x)
        }

        fn shape(&$self) -> Option<$crate::Shape<D>> {
            $set.shape()
        }

        fn pieces(&$self) -> Vec<Arc<dyn ClosedSet<D>>> {
            $set.pieces()
        }

        fn seeds(&$self) -> Vec<SVector<f64, D>> {
            $set.seeds()
        }
    };
}

/// A shared set is a set, so that a set chosen at run time can be passed on.
impl<const D: usize, S: ClosedSet<D> + ?Sized> ClosedSet<D> for Arc<S> {
    closed_set_by!(self => (**self));
}

/// Appends the pieces of `set`, recursively and in order, or `set` itself if it has no pieces.
pub(crate) fn append_pieces<const D: usize>(
    set: &Arc<dyn ClosedSet<D>>,
    pieces: &mut Vec<Arc<dyn ClosedSet<D>>>,
) {
    let own = set.pieces();
    if own.is_empty() {
        pieces.push(Arc::clone(set));
    }
    for piece in &own {
        append_pieces(piece, pieces);
    }
}

#[cfg(test)]
mod tests {
    use std::{cmp::Ordering, sync::Arc};

    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, cases, seed};
    use tautline_scalar::Interval;

    use crate::laws::Bare;
    use crate::numerics::exact::{Exact, point, squared_distances};
    use crate::numerics::proof::compare_distance;
    use crate::{
        AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment, SetError,
        Sphere, Union,
    };

    fn bounded_by(radius: Option<f64>) -> impl ClosedSet<2> {
        Bare { project: |_: &SVector<f64, 2>| SVector::zeros(), radius }
    }

    #[test]
    fn any_bounded_set_is_in_a_ball_about_the_origin() {
        let ball = |radius| bounded_by(radius).enclosing_ball();
        assert_eq!(ball(Some(3.0)), Some((vector![0.0, 0.0], 3.0)));
        assert_eq!(ball(None), None);
        // A NaN among other radii is kept.
        let nan: Arc<dyn ClosedSet<2>> = Arc::new(bounded_by(Some(f64::NAN)));
        let point: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([1.0, 2.0]).expect("finite"));
        for pieces in [[Arc::clone(&nan), Arc::clone(&point)], [point, nan]] {
            let union = Union::new(pieces.to_vec()).expect("two");
            assert!(union.radius().is_some_and(f64::is_nan));
            assert!(union.enclosing_ball().is_some_and(|(_, radius)| radius.is_nan()));
        }
    }

    #[test]
    fn a_shared_set_agrees_with_the_set() -> Result<(), SetError> {
        let sphere: Arc<dyn ClosedSet<2>> = Arc::new(Sphere::new([3.0, 4.0], 0.5)?);
        let point: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([9.0, 4.0])?);
        let union = Union::new(vec![Arc::clone(&sphere), point])?;
        let shared: Arc<dyn ClosedSet<2>> = Arc::new(Arc::new(union.clone()));
        let x = vector![4.0, 4.0];
        assert_eq!(shared.project(&x), vector![3.5, 4.0]);
        assert_eq!(shared.projection_derivative(&x), union.projection_derivative(&x));
        assert_eq!(shared.radius(), union.radius());
        assert_eq!(shared.enclosing_ball(), union.enclosing_ball());
        assert_ne!(shared.enclosing_ball(), bounded_by(union.radius()).enclosing_ball());
        assert_eq!(shared.member_near(&x), Some(vector![3.5, 4.0].map(Interval::point)));
        assert_eq!(shared.pieces().len(), 2);
        assert_eq!(shared.seeds(), sphere.seeds());
        assert_eq!(shared.seeds().len(), 4);
        assert!(!shared.is_convex() && Arc::new(Point::new([1.0, 2.0])?).is_convex());
        // A union of one piece is flattened like any other.
        let one = Union::new(vec![Arc::new(Union::new(vec![sphere])?)])?;
        assert!(one.pieces().iter().all(|piece| piece.pieces().is_empty()));
        Ok(())
    }

    /// Between two neighbouring doubles there is no double for the centre, but the ball still
    /// contains both ends.
    #[test]
    fn enclosing_balls_of_one_ulp_hold_both_ends() -> Result<(), SetError> {
        for low in [1.0, 1.0_f64.next_up(), -1.0, -(1.0_f64.next_up()), 0.0, -5e-324] {
            let high = low.next_up();
            let sides: [Arc<dyn ClosedSet<1>>; 3] = [
                Arc::new(AxisBox::from_corners([low], [high])?),
                Arc::new(Segment::new([low], [high])?),
                Arc::new(Segment::new([high], [low])?),
            ];
            for side in sides {
                let (centre, radius) = side.enclosing_ball().expect("bounded");
                for end in [low, high] {
                    assert!((end - centre[0]).abs() <= radius, "{side:?}: {centre:?}, {radius:e}");
                }
            }
        }
        Ok(())
    }

    /// Proofs take constants on these balls: no member may lie outside, not even by a rounding. Decided in
    /// exact arithmetic.
    #[test]
    fn enclosing_balls_hold_every_corner_exactly() -> Result<(), SetError> {
        let mut random = Random(seed(31));
        let mut nearest_fails = 0;
        for _ in 0..cases(2000) {
            let mut vector = || SVector::<f64, 3>::from_fn(|_, _| random.between(-2.0, 2.0));
            let (x, y, z) = (vector(), vector(), vector());
            let (lower, upper) = x.inf_sup(&y);
            let corner = |at: usize| {
                SVector::<f64, 3>::from_fn(
                    |i, _| if at >> i & 1 == 0 { lower[i] } else { upper[i] },
                )
            };
            let sets: [Arc<dyn ClosedSet<3>>; 4] = [
                Arc::new(AxisBox::from_corners(lower, upper)?),
                Arc::new(Segment::new(x, y)?),
                Arc::new(FiniteSet::new([x, y, z])?),
                Arc::new(Point::new(x)?),
            ];
            let corners = (0..8).map(corner).collect();
            for (set, members) in sets.iter().zip([corners, vec![x, y], vec![x, y, z], vec![x]]) {
                let about_the_origin = (SVector::zeros(), set.radius().expect("bounded"));
                for (centre, radius) in [set.enclosing_ball().expect("bounded"), about_the_origin] {
                    for x in &members {
                        let beyond = |r: f64| {
                            let order = compare_distance(x.as_slice(), centre.as_slice(), r);
                            order.is_none_or(Ordering::is_gt)
                        };
                        assert!(!beyond(radius), "{x} {centre} {radius:e}");
                        nearest_fails += usize::from(beyond((x - centre).norm()));
                    }
                }
            }
        }
        // Distances that are rounded to nearest are too small for about a third of the members.
        assert!(nearest_fails > 1000, "{nearest_fails}");
        Ok(())
    }

    /// A union of balls lies in its ball exactly: the sum of a distance and a radius is rounded up, too.
    #[test]
    fn the_ball_around_balls_holds_their_farthest_points() -> Result<(), SetError> {
        let mut random = Random(seed(32));
        for _ in 0..cases(500) {
            let mut ball = || {
                let centre = SVector::<f64, 2>::from_fn(|_, _| random.between(-2.0, 2.0));
                Ball::new(centre, random.between(0.0, 1.0))
            };
            let balls = [ball()?, ball()?];
            let pieces = balls.clone().map(|ball| Arc::new(ball) as Arc<dyn ClosedSet<2>>);
            let (centre, radius) = Union::new(pieces.to_vec())?.enclosing_ball().expect("bounded");
            for ball in balls {
                // The farthest member is at the distance |c − centre| + r.
                let rest = (Interval::point(radius) - ball.r()).hi();
                let inside = compare_distance(ball.centre_slice(), centre.as_slice(), rest);
                assert!(inside.is_some_and(Ordering::is_le), "{ball:?} {centre} {radius:e}");
            }
        }
        Ok(())
    }

    /// The farthest member from the origin is at the distance `|c| + r`. Decided in exact arithmetic.
    #[test]
    fn the_radii_of_balls_and_spheres_reach_their_farthest_points() -> Result<(), SetError> {
        let mut random = Random(seed(33));
        let mut nearest_fails = 0;
        for _ in 0..cases(500) {
            let centre = SVector::<f64, 3>::from_fn(|_, _| random.between(-2.0, 2.0));
            let r = random.between(0.0, 2.0);
            let (_, squared) = squared_distances(&point(&centre), &SVector::zeros());
            let reaches = |radius: f64| {
                let rest = Exact::new(radius).minus(&Exact::new(r));
                squared.at_most(&rest.times(&rest))
            };
            let nearest = centre.norm() + r;
            let sets: [&dyn ClosedSet<3>; 2] = [&Ball::new(centre, r)?, &Sphere::new(centre, r)?];
            for set in sets {
                let radius = set.radius().expect("bounded");
                // Fewer than twenty roundings of positive numbers.
                assert!(reaches(radius) && radius <= nearest * (1.0 + 4e-15), "{set:?} {radius:e}");
            }
            nearest_fails += usize::from(!reaches(nearest));
        }
        assert!(nearest_fails > 100, "{nearest_fails}");
        Ok(())
    }

    /// The balls are centred at the sets themselves, not at the origin.
    #[test]
    fn enclosing_balls_are_small() -> Result<(), SetError> {
        let ball = |set: &dyn ClosedSet<2>| set.enclosing_ball();
        let about = |x: f64, y: f64, radius: f64| Some((vector![x, y], radius));
        assert_eq!(ball(&Point::new([3.0, 4.0])?), about(3.0, 4.0, 0.0));
        assert_eq!(ball(&Ball::new([3.0, 4.0], 0.5)?), about(3.0, 4.0, 0.5));
        assert_eq!(ball(&Sphere::new([3.0, 4.0], 0.5)?), about(3.0, 4.0, 0.5));
        assert_eq!(ball(&Segment::new([0.0, 5.0], [6.0, 13.0])?), about(3.0, 9.0, 5.0));
        assert_eq!(ball(&AxisBox::new([7.0, 8.0], [3.0, 4.0])?), about(7.0, 8.0, 5.0));
        assert_eq!(ball(&FiniteSet::new([[0.0, 1.0], [4.0, 1.0]])?), about(2.0, 1.0, 2.0));
        let none: [SVector<f64, 2>; 0] = [];
        assert_eq!(ball(&AffineSubspace::new([1.0, 2.0], none)?), about(1.0, 2.0, 0.0));
        let wall = HalfSpace::new([1.0, 0.0], 0.0)?;
        assert_eq!(ball(&wall), None);
        let disc: Arc<dyn ClosedSet<2>> = Arc::new(Ball::new([1.0, 0.0], 1.0)?);
        let far: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([5.0, 0.0])?);
        assert_eq!(ball(&Union::new(vec![Arc::clone(&disc), far])?), about(3.0, 0.0, 3.0));
        assert_eq!(ball(&Union::new(vec![disc, Arc::new(wall)])?), None);
        // Here sums of two coordinates would overflow.
        let most = 2_f64.powi(1023);
        let huge = AxisBox::from_corners([0.5 * most, 0.0], [1.5 * most, 0.0])?;
        let (centre, radius) = ball(&huge).expect("bounded");
        // So near the largest double an interval does not know that a difference is exact.
        assert!(centre == vector![most, 0.0] && radius <= (0.5 * most).next_up(), "{radius:e}");
        Ok(())
    }
}
