//! A common point of two sets, proved by exact arithmetic.

use nalgebra::SVector;
use tautline_scalar::ANY;

use crate::numerics::norm::norm;
use crate::numerics::place::{Place, largest, minus};
use crate::numerics::proof;
use crate::{AnySet, ClosedSet, InAny, Shape};

/// How deep in a set a point is sought: by up to `2^40` roundings of the numbers of the set, which is
/// four digits.
const DEPTHS: i32 = 40;

/// How often a point is moved into the one set and then into the other, for each depth.
const ROUNDS: usize = 8;

/// Looks for a point near `near` that is proved to be a member of both sets, in `ℓ`.
///
/// [`common_point`](crate::common_point()) returns points that are members up to rounding. Under a metric
/// with a large scale a rounding may be a long way, so that only a proved common point shows that a
/// distance is 0. Members are proved by [`ClosedSet::member_near`]. Tried are `near`, its projections,
/// and those of the centres of the sets; then `near` is moved deeper and deeper into both, if they are
/// [elementary](Shape::into_elementary). For unions, call this function pair by pair
/// ([`Ends::pairs`](crate::Ends::pairs)).
///
/// `None` does not prove that the sets are disjoint: they may touch in a point whose coordinates are no
/// doubles, or overlap by no more than a few roundings.
///
/// ```
/// use nalgebra::vector;
/// use tautline_sets::{Ball, SetError, proved_common_point};
///
/// let near = vector![1.0, 0.0];
/// let ball = |x: f64| Ball::new([x, 0.0], 1.0);
/// assert_eq!(proved_common_point(&ball(0.0)?, &ball(2.0)?, &near), Some(near));
/// assert_eq!(proved_common_point(&ball(0.0)?, &ball(2.0_f64.next_up())?, &near), None);
/// # Ok::<(), SetError>(())
/// ```
#[must_use]
pub fn proved_common_point<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
    near: &SVector<f64, D>,
) -> Option<SVector<f64, D>> {
    let x = proved_common_point_of(&InAny(a), &InAny(b), near.as_slice())?;
    Some(SVector::from_column_slice(&x))
}

/// Looks for a proved common point like [`proved_common_point`], in a dimension that is a value.
#[must_use]
pub fn proved_common_point_of(a: &dyn AnySet, b: &dyn AnySet, near: &[f64]) -> Option<Vec<f64>> {
    let is_common = |x: &[f64]| is_member(a, x) && is_member(b, x);
    let projected = |set: &dyn AnySet, x: &[f64]| {
        let mut x = Place::from_slice(x);
        set.project(&mut x);
        x
    };
    let centre = |set: &dyn AnySet| set.enclosing_ball().map(|(centre, _)| centre);
    let feet = [
        Some(Place::from_slice(near)),
        Some(projected(a, near)),
        Some(projected(b, near)),
        centre(a).map(|x| projected(b, &x)),
        centre(b).map(|x| projected(a, &x)),
    ];
    if let Some(x) = feet.into_iter().flatten().find(|x| is_common(x)) {
        return Some(x.to_vec());
    }
    let (one, other) = (a.shape()?.into_elementary()?, b.shape()?.into_elementary()?);
    let size = size(&one, near).max(size(&other, near));
    let deepest = f64::EPSILON * size * 2.0_f64.powi(DEPTHS);
    if [a, b].iter().any(|&set| largest(&minus(&projected(set, near), near)) > deepest) {
        return None;
    }
    for depth in (0..=DEPTHS).map(|k| f64::EPSILON * size * 2.0_f64.powi(k)) {
        let mut x = Place::from_slice(near);
        for _ in 0..ROUNDS {
            x = moved_into(&other, &moved_into(&one, &x, depth), depth);
            if is_common(&x) {
                return Some(x.to_vec());
            }
        }
    }
    None
}

impl<const D: usize> Shape<D> {
    /// Returns a member near `x` that is [proved](Shape::contains): `x` or its projection if they are
    /// members, or else a point that is a few roundings deeper. `None` if none is found.
    #[must_use]
    pub fn proved_member(&self, x: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        let x = x.as_slice();
        let any = self.clone().into_any();
        let pieces = any.pieces().into_iter().filter_map(|piece| {
            let size = size(piece, x);
            let depths = (0..=DEPTHS).map(|k| f64::EPSILON * size * 2.0_f64.powi(k));
            let inner = depths.map(|depth| moved_into(piece, x, depth));
            let first = [Place::from_slice(x), moved_into(piece, x, 0.0)];
            first.into_iter().chain(inner).find(|x| piece.contains(x.as_slice()))
        });
        let nearest = pieces.min_by(|a, b| norm(&minus(a, x)).total_cmp(&norm(&minus(b, x))));
        nearest.map(|x| SVector::from_column_slice(&x))
    }
}

/// Returns whether a point is proved to be a member.
fn is_member(set: &dyn AnySet, x: &[f64]) -> bool {
    set.member_near(x).is_some_and(|member| member == proof::point(x))
}

/// Returns the largest number that the roundings of a piece near `x` belong to.
fn size(piece: &Shape<ANY>, x: &[f64]) -> f64 {
    let own = match piece {
        Shape::Ball(ball) => largest(ball.centre_slice()) + ball.r(),
        Shape::HalfSpace(wall) => wall.offset().abs(),
        Shape::AxisBox(side) => {
            let [lower, upper] = side.corner_slices().map(largest);
            lower.max(upper)
        }
        _ => 0.0,
    };
    own.max(largest(x))
}

/// Returns the nearest point that is deeper in a piece than `depth`, or the middle of a piece that is
/// not as deep.
fn moved_into(piece: &Shape<ANY>, x: &[f64], depth: f64) -> Place {
    let mut moved = Place::from_slice(x);
    match piece {
        Shape::Ball(ball) => {
            let (away, r) = (minus(x, ball.centre_slice()), (ball.r() - depth).max(0.0));
            let distance = norm(&away);
            if !(distance <= r) {
                let share = r / distance;
                moved = ball.centre_slice().iter().zip(&away).map(|(c, u)| c + u * share).collect();
            }
        }
        Shape::HalfSpace(wall) => {
            let height = wall.height(x) + depth;
            if !(height <= 0.0) {
                wall.sink(&mut moved, height);
            }
        }
        Shape::AxisBox(side) => {
            let [lower, upper] = side.corner_slices();
            for ((x, &low), &high) in moved.iter_mut().zip(lower).zip(upper) {
                let depth = depth.min(0.5 * (high - low));
                *x = x.max(low + depth).min(high - depth).clamp(low, high);
            }
        }
        Shape::Union(_) => {}
        thin => AnySet::project(thin, &mut moved),
    }
    moved
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, seed};

    use super::proved_common_point;
    use crate::{
        AxisBox, Ball, ClosedSet, HalfSpace, Point, Segment, Shape, Sphere, Union, common_point,
    };

    fn proved<const D: usize>(
        a: &dyn ClosedSet<D>,
        b: &dyn ClosedSet<D>,
    ) -> Option<SVector<f64, D>> {
        proved_common_point(a, b, &common_point(a, b).expect("common up to rounding"))
    }

    /// Half an ulp between two balls is no contact. Points are known exactly: an ulp apart they do not even
    /// touch up to rounding.
    #[test]
    fn sets_that_touch_up_to_rounding_have_no_proved_point() {
        let ball = |x: f64| Ball::new([x, 0.0], 1.0).expect("finite");
        let apart = 2.0 + 2.0_f64.powi(-51);
        assert_eq!(proved(&ball(0.0), &ball(apart)), None);
        assert_eq!(proved(&ball(apart), &ball(0.0)), None);
        assert_eq!(proved(&ball(0.0), &ball(2.0)), Some(vector![1.0, 0.0]));
        let point = |x: f64| Point::new([x, 7.0]).expect("finite");
        assert_eq!(common_point(&point(1.0), &point(1.0_f64.next_up())), None);
        assert_eq!(proved(&point(1.0), &point(1.0)), Some(vector![1.0, 7.0]));
        let wall = |b: f64| HalfSpace::at_least([3.0, 4.0], b).expect("a normal");
        // The half-space 3x + 4y ≥ 5 touches the unit disc at (0.6, 0.8), whose coordinates are no
        // doubles.
        assert_eq!(proved(&ball(0.0), &wall(5.0)), None);
        assert!(proved(&ball(0.0), &wall(5.0 - 1e-14)).is_some());
    }

    #[test]
    fn sets_that_touch_in_a_double_have_a_proved_point() {
        let side = AxisBox::from_corners([1.0, -1.0], [2.0, 1.0]).expect("ordered");
        let ball = Ball::new([0.0, 0.25], 1.0).expect("finite");
        assert_eq!(proved(&ball, &side), Some(vector![1.0, 0.25]));
        let sphere = Sphere::new([0.0, 0.25], 1.0).expect("finite");
        assert_eq!(proved(&sphere, &side), Some(vector![1.0, 0.25]));
        let segment = Segment::new([1.0, 0.0], [1.0, 3.0]).expect("finite");
        assert!(proved(&segment, &side).is_some());
        let pieces: [Arc<dyn ClosedSet<2>>; 2] =
            [Arc::new(Point::new([9.0, 9.0]).expect("finite")), Arc::new(ball)];
        let union = Union::new(pieces.to_vec()).expect("two");
        let near = vector![1.0, 0.25];
        assert_eq!(proved_common_point(&union, &side, &near), Some(near));
    }

    /// The member is that of the nearest piece, in whatever order the pieces are and however deep
    /// unions are nested.
    #[test]
    fn the_proved_member_of_a_union_is_in_its_nearest_piece() {
        let ball = |x: f64| Shape::Ball(Ball::new([x, 0.0], 1.0).expect("finite"));
        let spot = Shape::Point(Point::new([50.0, 0.0]).expect("finite"));
        let wall = Shape::HalfSpace(HalfSpace::at_least([1.0, 0.0], 90.0).expect("a normal"));
        let mut pieces = [ball(0.0), spot, ball(20.0), wall];
        for _ in 0..pieces.len() {
            pieces.rotate_left(1);
            let [first, others @ ..] = &pieces;
            let nested = Shape::Union(vec![first.clone(), Shape::Union(others.to_vec())]);
            for union in [Shape::Union(pieces.to_vec()), nested] {
                let member = |x: f64| union.proved_member(&vector![x, 0.0]);
                // Two of these are the ends of balls, the others members as they stand.
                for (x, nearest) in
                    [(2.0, 1.0), (17.0, 19.0), (20.5, 20.5), (49.0, 50.0), (80.0, 90.0)]
                {
                    assert_eq!(member(x), Some(vector![nearest, 0.0]), "{x}: {union:?}");
                }
            }
        }
    }

    /// Whatever is returned is a member of both; what overlaps by a millionth is always found.
    #[test]
    fn random_sets_that_overlap_have_a_proved_point() {
        let mut random = Random(seed(2));
        for case in 0..600 {
            let mut number = |size: f64| random.between(-size, size);
            let centre = vector![number(30.0), number(30.0), number(30.0)];
            let r = number(2.0).abs() + 1e-3;
            let away = vector![number(1.0), number(1.0), number(1.0)].normalize();
            let overlap = 1e-6;
            let at = centre + away * (r - overlap);
            let other = match case % 3 {
                0 => {
                    let s = number(5.0).abs() + 1e-3;
                    Shape::Ball(Ball::new(at + away * s, s).expect("finite"))
                }
                1 => {
                    let n = -away * (number(9.0).abs() + 1e-3);
                    Shape::HalfSpace(HalfSpace::new(n, n.dot(&at)).expect("a normal"))
                }
                _ => {
                    let corner = at + vector![number(1.0), number(1.0), number(1.0)];
                    let (low, high) = at.inf_sup(&corner);
                    Shape::AxisBox(AxisBox::from_corners(low, high).expect("ordered"))
                }
            };
            let ball = Ball::new(centre, r).expect("finite");
            let set: Arc<dyn ClosedSet<3>> = match &other {
                Shape::Ball(set) => Arc::new(set.clone()),
                Shape::HalfSpace(set) => Arc::new(set.clone()),
                Shape::AxisBox(set) => Arc::new(set.clone()),
                _ => unreachable!(),
            };
            let x = proved_common_point(&ball, &*set, &at).expect("they overlap");
            assert!(
                Shape::Ball(ball.clone()).contains(&x) && other.contains(&x),
                "{ball:?} {other:?}"
            );
            // A point from far away is moved to a member, by no more than a few roundings too far.
            let far = at + away * 7.0;
            for set in [Shape::Ball(ball), other] {
                let member = set.proved_member(&far).expect("a member");
                let nearest = match &set {
                    Shape::Ball(set) => set.project(&far),
                    Shape::HalfSpace(set) => set.project(&far),
                    Shape::AxisBox(set) => set.project(&far),
                    _ => unreachable!(),
                };
                assert!(set.contains(&member), "{set:?}");
                assert!((member - nearest).amax() < 64.0 * f64::EPSILON * 60.0, "{set:?}");
            }
        }
    }
}
