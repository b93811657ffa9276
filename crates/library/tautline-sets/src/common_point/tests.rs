//! Sets that touch, and sets that do not.

use super::common_point;
use crate::laws::{Bare, runner, scale, unwrap, vector_in};
use crate::{AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, InAny, Point, Segment, Sphere};
use nalgebra::{SVector, vector};
use proptest::prelude::*;

fn lies_in_both<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
    x: &SVector<f64, D>,
) -> bool {
    super::lies_in_both(&InAny(a), &InAny(b), x.as_slice())
}

/// A point may be off by `(D + 4) ε = 7 ε` times its largest coordinate.
#[test]
fn a_point_lies_in_a_set_up_to_seven_roundings_in_space() {
    let off = |count: f64| {
        // A set that can prove nothing, and knows its nearest points up to rounding.
        let project = move |_: &SVector<f64, 3>| vector![1.0 + count * f64::EPSILON, 0.5, 0.25];
        let set = Bare { project, radius: Some(2.0) };
        lies_in_both(&set, &set, &vector![1.0, 0.5, 0.25])
    };
    assert!(off(0.0) && off(6.0) && !off(9.0));
}

#[test]
fn common_point_of_balls_that_touch_away_from_the_line_to_the_origin() {
    // The centres are 5 apart and the radii are 2 and 3, so that the balls touch at (4.2, 5.4).
    let a = Ball::new([3.0, 7.0], 2.0).expect("finite");
    let b = Ball::new([6.0, 3.0], 3.0).expect("finite");
    let x = common_point(&a, &b).expect("they touch");
    // A gap of a few ε in coordinates up to 7 extends over a few √(7 ε) around the contact.
    assert!((x - vector![4.2, 5.4]).norm() <= 1e-6, "{x}");
}

/// The sets touch in a direction unrelated to the origin.
///
/// The search needs Douglas–Rachford: alternating projections alone stall at a gap of about
/// 1e-11.
#[test]
fn common_point_of_a_ball_that_touches_a_plane_a_ball_or_a_hollow_sphere() {
    let numbers = (vector_in::<3>(3.0), 0.1..2.0_f64, vector_in::<3>(1.0), 0.1..2.0_f64);
    let result = runner().run(&(numbers, scale()), |((c, r, n, s), unit)| {
        prop_assume!(n.norm() > 0.1);
        let n = n.normalize();
        let [at, size] = [c * unit, n * unit];
        let ball = Ball::new(at, r * unit).expect("finite");
        let plane = HalfSpace::at_least(n, n.dot(&at) + r * unit).expect("a normal");
        let outside = Ball::new(at + size * (r + s), s * unit).expect("finite");
        let around = Sphere::new(at - size * r, 2.0 * r * unit).expect("finite");
        let others: [&dyn ClosedSet<3>; 3] = [&plane, &outside, &around];
        for other in others {
            let Some(x) = common_point(&ball, other) else {
                return Err(TestCaseError::fail(format!("not found: {other:?}")));
            };
            let x = x / unit;
            // A gap of D + 4 = 7 ε in coordinates up to 9 extends over √(2 · 63 ε ρ) along sets
            // that separate like t²/2ρ. Here ρ ≤ 2 r ≤ 4, which makes it less than 4e-7.
            let beside = (x - (c + n * r)).norm();
            prop_assert!(beside <= 1e-6, "{beside:e} from the contact with {other:?}");
            // This check uses the formula of the ball, with the rounding of this line.
            prop_assert!((x - c).norm() <= r + 100.0 * f64::EPSILON, "outside the ball");
        }
        Ok(())
    });
    unwrap(result);
}

#[test]
fn common_point_is_none_across_a_gap() {
    let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
    // A gap of 1e-12 is about 4500 ε, so it is not due to rounding.
    let wall = HalfSpace::at_least([0.6, 0.8], 1.0 + 1e-12).expect("a normal");
    assert_eq!(common_point(&ball, &wall), None);
    let points = [[0.0, 0.0], [0.0, 5e-324]].map(|p| Point::new(p).expect("finite"));
    assert_eq!(common_point(&points[0], &points[1]), None);
    assert_eq!(common_point(&points[1], &points[1]), Some(vector![0.0, 5e-324]));
}

#[test]
fn common_point_at_a_corner_and_of_a_flat_set() {
    let a = AxisBox::from_corners([0.0, 0.0], [1.0, 1.0]).expect("ordered");
    let b = AxisBox::from_corners([1.0, 1.0], [2.0, 2.0]).expect("ordered");
    assert_eq!(common_point(&a, &b), Some(vector![1.0, 1.0]));
    let across = Segment::new([-1.0, 2.0], [3.0, -1.0]).expect("finite");
    assert!(common_point(&a, &across).is_some());
}

#[test]
fn common_point_of_spheres_needs_their_seeds() {
    // The origin is the centre of the first sphere. It projects to (1, 0), far from the second
    // one.
    let a = Sphere::new([0.0, 0.0], 1.0).expect("finite");
    let b = Sphere::new([-1.5, 0.0], 1.0).expect("finite");
    let x = common_point(&a, &b).expect("they cross");
    // They cross at x₁ = −0.75, at an angle that is not small: a few ε for each sphere suffice.
    assert!((x[0] + 0.75).abs() <= 100.0 * f64::EPSILON, "{x}");
    let apart = Sphere::new([0.0, 0.0], 0.5).expect("finite");
    assert_eq!(common_point(&a, &apart), None);
}

/// The result depends neither on the order of the sets nor on the unit.
#[test]
fn common_point_is_found_in_either_order_and_every_unit() {
    for unit in [1e-200, 1.0, 1e200] {
        let ring = |x: f64, r: f64| Sphere::new([x * unit, 0.0], r * unit).expect("finite");
        // The origin is the centre of the first ring and projects to the far side, so seeds are
        // needed.
        let crossing = (ring(0.0, 1.0), ring(-1.5, 1.0));
        // A small ball touches a plane in an oblique direction.
        let ball = Ball::new([3.0 * unit, 4.0 * unit], 2.0 * unit).expect("finite");
        let plane = |b: f64| HalfSpace::new([0.6, 0.8], b * unit).expect("a normal");
        let pairs: [(&dyn ClosedSet<2>, &dyn ClosedSet<2>, bool); 4] = [
            (&crossing.0, &crossing.1, true),
            (&ring(0.0, 0.5), &ring(-1.5, 0.5), false),
            (&ball, &plane(3.0), true),
            (&ball, &plane(3.0 - 1e-9), false),
        ];
        for (a, b, meet) in pairs {
            assert_eq!(common_point(a, b).is_some(), meet, "{a:?} {b:?}");
            assert_eq!(common_point(b, a).is_some(), meet, "{b:?} {a:?}");
        }
    }
}

#[test]
fn a_point_lies_in_both_only_if_no_coordinate_of_either_misses() {
    let x = vector![1.0, 2.0];
    let here = Point::new(x).expect("finite");
    assert!(lies_in_both(&here, &here, &x));
    for beside in [vector![1.0 + 1e-12, 2.0], vector![1.0, 2.0 + 1e-12]] {
        let beside = Point::new(beside).expect("finite");
        assert!(!lies_in_both(&here, &beside, &x) && !lies_in_both(&beside, &here, &x));
    }
    // The comparison is relative, so it holds for small numbers too.
    let tiny = Point::new(x * 1e-20).expect("finite");
    assert!(!lies_in_both(&tiny, &tiny, &(x * 2e-20)));
}

/// For each kind of start there is a pair of sets that needs it.
#[test]
fn common_point_needs_the_seeds_of_either_set_and_both_projections_of_the_origin() {
    // The origin and its nearest point in the ball are the centre of the sphere, which always
    // projects to the far side. A ball has no seeds.
    let sphere = Sphere::new([0.0, 0.0], 1.0).expect("finite");
    let ball = Ball::new([-0.5, 0.0], 0.5).expect("finite");
    assert_eq!(common_point(&sphere, &ball), Some(vector![-1.0, 0.0]));
    assert_eq!(common_point(&ball, &sphere), Some(vector![-1.0, 0.0]));
    // From the origin the first set gives (1, 0), (2.5, 0), (1, 0) and so on, none of which is
    // common. The second set gives (0, 2), which is.
    let a = FiniteSet::new([[1.0, 0.0], [0.0, 2.0]]).expect("finite");
    let b = FiniteSet::new([[2.5, 0.0], [0.0, 2.0]]).expect("finite");
    assert_eq!(common_point(&a, &b), Some(vector![0.0, 2.0]));
    assert_eq!(common_point(&b, &a), Some(vector![0.0, 2.0]));
}

/// A small ball touches a huge ball, and a huge sphere from outside and from inside. The huge
/// set is up to a million times as large, and may come first or second.
#[test]
fn common_point_of_a_small_set_and_a_huge_one() {
    let (c, r, n) = (vector![1.0, 2.0], 0.25, vector![0.6, 0.8]);
    let small = Ball::new(c, r).expect("finite");
    for power in 0..=6 {
        let s = 10.0_f64.powi(power);
        let ball = Ball::new(c + n * (r + s), s).expect("finite");
        let beside = Sphere::new(c + n * (r + s), s).expect("finite");
        let around = Sphere::new(c + n * (r - s), s).expect("finite");
        let others: [&dyn ClosedSet<2>; 3] = [&ball, &beside, &around];
        for other in others {
            for found in [common_point(&small, other), common_point(other, &small)] {
                let off = (found.expect("they touch") - (c + n * r)).norm();
                // An overlap or a gap δ = 6 ε of numbers up to s + 3 extends over √(2 δ ρ)
                // around the contact, where ρ ≤ r s/(s − r) ≤ 1/3 for both curvatures.
                let allowed = 2.0 * (f64::EPSILON * (s + 3.0)).sqrt();
                assert!(off <= allowed, "{off:e} from the contact with {other:?}");
            }
        }
    }
}

#[test]
fn common_point_handles_the_largest_and_smallest_numbers() {
    for scale in [1e-300, 1e300] {
        let a = Ball::new([3.0 * scale, 0.0], 2.0 * scale).expect("finite");
        let b = Ball::new([0.0, 3.0 * scale], 3.0 * scale).expect("finite");
        let x = common_point(&a, &b).expect("they cross") / scale;
        assert!((x - vector![3.0, 0.0]).norm() <= 2.0 + 1e-12);
        assert!((x - vector![0.0, 3.0]).norm() <= 3.0 + 1e-12);
    }
}

#[test]
fn a_point_that_is_nan_in_one_coordinate_lies_nowhere() {
    let all = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("a box");
    // The nearest points are NaN in one coordinate and agree with x in the other.
    for nan in 0..2 {
        let project = move |x: &SVector<f64, 2>| {
            SVector::from_fn(|i, _| if i == nan { f64::NAN } else { x[i] })
        };
        let half = Bare { project, radius: Some(1.0) };
        for x in [vector![0.5, 0.5], vector![f64::NAN, 0.5], vector![0.5, f64::NAN]] {
            assert!(!lies_in_both(&half, &all, &x) && !lies_in_both(&all, &half, &x), "{x}");
        }
        assert_eq!((common_point(&half, &all), common_point(&all, &half)), (None, None));
    }
}

#[test]
fn common_point_is_never_nan() {
    let ball = Ball::new([0.0, 0.0], 1.0).expect("finite");
    let project = |_: &SVector<f64, 2>| SVector::repeat(f64::NAN);
    let empty = Bare { project, radius: Some(0.0) };
    assert_eq!(common_point(&ball, &empty), None);
    assert_eq!(common_point(&empty, &ball), None);
}

/// A frequency in hertz beside an angle: half a radian is less than the rounding of the frequency.
#[test]
fn points_and_boxes_touch_exactly_or_not_at_all() {
    let [one, other] = [0.0, 0.5].map(|x| Point::new([5e14, x]).expect("finite"));
    assert_eq!(common_point(&one, &other), None);
    assert_eq!(common_point(&one, &one), Some(vector![5e14, 0.0]));
    let from = |x: f64| AxisBox::from_corners([5e14, x], [6e14, x + 1.0]).expect("a box");
    assert_eq!(common_point(&from(-1.5), &one), None);
    assert_eq!(common_point(&from(-1.5), &from(-0.25)), None);
    assert_eq!(common_point(&from(-1.5), &from(-0.5)).map(|x| x[1]), Some(-0.5));
    // The next double above.
    let near = Point::new([5e14_f64.next_up(), 0.0]).expect("finite");
    assert_eq!(common_point(&one, &near), None);
}
