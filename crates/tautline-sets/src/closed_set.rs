//! `ClosedSet`: a non-empty closed subset of `R^D`, given by its nearest-point map.

use std::fmt::Debug;
use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Interval;

/// A non-empty closed subset `X` of `R^D`, given by its Euclidean nearest-point map `P`.
///
/// # Laws
///
/// For finite `x`, with rounding granted:
///
/// - `P(x)` lies in `X`, `P(P(x)) = P(x)`, and no member of `X` is nearer to `x` than `P(x)`;
/// - if [`is_convex`](ClosedSet::is_convex), then `|P(x) − P(y)| ≤ |x − y|`, and the derivative
///   has its eigenvalues in `[0, 1]`;
/// - no member of `X` is longer than [`radius`](ClosedSet::radius), nor, up to rounding,
///   outside of its [`enclosing_ball`](ClosedSet::enclosing_ball);
/// - a box from [`member_near`](ClosedSet::member_near) contains a member of `X`, without any
///   rounding granted.
///
/// No method panics on finite input; none reads a clock, a file or a random number. An empty
/// set has no nearest point: an implementation which may be empty returns NaN, and
/// [`Ends::new`](crate::Ends::new) refuses it.
///
/// A set of your own, here a strip:
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
    /// Returns a nearest point `P(x)` of the set to `x`, in `ℓ`.
    ///
    /// Where several are nearest (the set is not convex), returns any one of them, but the
    /// same one each time.
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D>;

    /// Returns an element of the generalised derivative of `P` at `x` in the sense of Clarke:
    /// a limit of derivatives `DP(xₖ)`, `xₖ → x`. A pure number; symmetric.
    ///
    /// Where `P` is smooth, this is its derivative: `P` is the gradient of
    /// `½|x|² − ½ dist(x, X)²`, hence the symmetry. At a kink the point counts as inside: a
    /// point of the set where it has interior has derivative `I`, its boundary included. Where
    /// `P` jumps (`x` is equally far from two places), the derivative is that of the branch
    /// which [`project`](ClosedSet::project) has chosen.
    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D>;

    /// Returns `sup |x|` over the set, in `ℓ`; `None` if the set is unbounded.
    fn radius(&self) -> Option<f64>;

    /// Returns the centre and the radius of a ball that contains the set, in `ℓ`; `None` if the set
    /// is unbounded.
    ///
    /// It need not be the smallest: by default it is the ball about the origin. Worth overriding
    /// for a set that lies far from there, since constants that hold on a region are better on a
    /// smaller one.
    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        Some((SVector::zeros(), self.radius()?))
    }

    /// Returns whether the set is known to be convex. `false` claims nothing.
    ///
    /// Under a constant metric the distance to a convex set has no local minimum but the
    /// global one, so a convex set has no [`seeds`](ClosedSet::seeds).
    fn is_convex(&self) -> bool {
        false
    }

    /// Returns a box that certainly contains a member of the set, as near to `x` as the set can
    /// prove, in `ℓ`; `None` if it can prove nothing, as by default.
    ///
    /// The box is `[x, x]` if and only if `x` itself is proved to be a member, else a box of a few
    /// roundings about `P(x)`. It says nothing of where in the box the members are. The set is
    /// meant exactly: the numbers that it was made of are the doubles which they are, and whatever
    /// was rounded in making it, such as the length of a normal, does not enter.
    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        let _ = x;
        None
    }

    /// Returns the members of a union, each to be searched separately; empty if the set is
    /// one piece.
    fn pieces(&self) -> &[Arc<dyn ClosedSet<D>>] {
        &[]
    }

    /// Returns further points of the set, in `ℓ`, from which a local search should start: a
    /// set which is not convex, such as a sphere, has several local solutions.
    fn seeds(&self) -> Vec<SVector<f64, D>> {
        Vec::new()
    }
}

/// A shared set is a set, so that one which is chosen at run time can be passed on.
impl<const D: usize, S: ClosedSet<D> + ?Sized> ClosedSet<D> for Arc<S> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        (**self).project(x)
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        (**self).projection_derivative(x)
    }

    fn radius(&self) -> Option<f64> {
        (**self).radius()
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        (**self).enclosing_ball()
    }

    fn is_convex(&self) -> bool {
        (**self).is_convex()
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        (**self).member_near(x)
    }

    fn pieces(&self) -> &[Arc<dyn ClosedSet<D>>] {
        (**self).pieces()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        (**self).seeds()
    }
}

/// Appends the pieces of `set`, and theirs in turn, in order; `set` itself if it has none.
pub(crate) fn append_pieces<const D: usize>(
    set: &Arc<dyn ClosedSet<D>>,
    pieces: &mut Vec<Arc<dyn ClosedSet<D>>>,
) {
    if set.pieces().is_empty() {
        pieces.push(Arc::clone(set));
    }
    for piece in set.pieces() {
        append_pieces(piece, pieces);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SMatrix, SVector, vector};
    use tautline_scalar::Interval;

    use crate::{
        AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment, SetError,
        Sphere, Union,
    };

    /// A set that says no more than it has to.
    #[derive(Debug)]
    struct Anything {
        radius: Option<f64>,
    }

    impl ClosedSet<2> for Anything {
        fn project(&self, _: &SVector<f64, 2>) -> SVector<f64, 2> {
            SVector::zeros()
        }

        fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }

        fn radius(&self) -> Option<f64> {
            self.radius
        }
    }

    #[test]
    fn any_bounded_set_is_in_a_ball_about_the_origin() {
        let ball = |radius| Anything { radius }.enclosing_ball();
        assert_eq!(ball(Some(3.0)), Some((vector![0.0, 0.0], 3.0)));
        assert_eq!(ball(None), None);
        // What bounds nothing is not lost among others.
        let nan: Arc<dyn ClosedSet<2>> = Arc::new(Anything { radius: Some(f64::NAN) });
        let point: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([1.0, 2.0]).expect("finite"));
        for pieces in [[Arc::clone(&nan), Arc::clone(&point)], [point, nan]] {
            let union = Union::new(pieces.to_vec()).expect("two");
            assert!(union.radius().is_some_and(f64::is_nan));
            assert!(union.enclosing_ball().is_some_and(|(_, radius)| radius.is_nan()));
        }
    }

    /// Nothing is lost behind a pointer: the pieces, the seeds and the ball of a set are its own.
    #[test]
    fn a_shared_set_says_what_the_set_says() -> Result<(), SetError> {
        let sphere: Arc<dyn ClosedSet<2>> = Arc::new(Sphere::new([3.0, 4.0], 0.5)?);
        let point: Arc<dyn ClosedSet<2>> = Arc::new(Point::new([9.0, 4.0])?);
        let union = Union::new(vec![Arc::clone(&sphere), point])?;
        let shared: Arc<dyn ClosedSet<2>> = Arc::new(Arc::new(union.clone()));
        let x = vector![4.0, 4.0];
        assert_eq!(shared.project(&x), vector![3.5, 4.0]);
        assert_eq!(shared.projection_derivative(&x), union.projection_derivative(&x));
        assert_eq!(shared.radius(), union.radius());
        assert_eq!(shared.enclosing_ball(), union.enclosing_ball());
        assert_ne!(shared.enclosing_ball(), Anything { radius: union.radius() }.enclosing_ball());
        assert_eq!(shared.member_near(&x), Some(vector![3.5, 4.0].map(Interval::point)));
        assert_eq!(shared.pieces().len(), 2);
        assert_eq!(shared.seeds(), sphere.seeds());
        assert_eq!(shared.seeds().len(), 4);
        assert!(!shared.is_convex() && Arc::new(Point::new([1.0, 2.0])?).is_convex());
        // A union of one piece is dissolved like any other.
        let one = Union::new(vec![Arc::new(Union::new(vec![sphere])?)])?;
        assert!(one.pieces().iter().all(|piece| piece.pieces().is_empty()));
        Ok(())
    }

    /// A side of one ulp has no double in the middle: the ball reaches to both ends all the same.
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

    /// Those of the sets themselves, not those about the origin.
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
        // Sums of two coordinates would be beyond f64.
        let most = 2_f64.powi(1023);
        let huge = AxisBox::from_corners([0.5 * most, 0.0], [1.5 * most, 0.0])?;
        assert_eq!(ball(&huge), about(most, 0.0, 0.5 * most));
        Ok(())
    }
}
