//! Random problems: metrics whose distance is known exactly, between points and between sets.
//!
//! | metric | sets | `d` |
//! | --- | --- | --- |
//! | constant `A` | points | `∣A^{1/2} (x − y)∣` |
//! | | ball about `c`, half-space `{a·x ≥ b}` | `(b − a·c − r∣a∣) / (aᵀA⁻¹a)^{1/2}` |
//! | | finite sets | the smallest over all pairs |
//! | shear | points | `∣Φ(x) − Φ(y)∣` |
//! | | ball, half-plane `{x₂ ≥ b}` | `b − c₂ − r`, since `Φ` keeps `x₂` |
//! | separable | points | `∣F(x) − F(y)∣` |
//! | | box, half-space `{xᵢ ≥ b}` | `Fᵢ(b) − Fᵢ(uᵢ)`, since `F` maps boxes to boxes |
//! | | box, box | the distance of their images under `F`, which are boxes |
//! | ramp | points | `∣F(x) − F(y)∣` |
//! | valleys | points along `x₁` | `F(b) − F(a)` |
//! | | points across | by Clairaut's relation, if it has a solution |
//! | | ball, half-space `{x₁ ≥ b}` | `F(b) − F(c₁ + r)`, since `∣∇F(x₁)∣ = f` everywhere |

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::{
    AxisBox, Ball, Bounded, Ends, FiniteSet, HalfSpace, KnownDistance, SVector,
    gallery::{Constant, Separable, Shear, Valleys},
};
use tautline_statements::Known;

use super::{
    metrics::{constant, matrix, separable, shear},
    points::{two_points, vector},
};

/// The rounding error of a distance between sets, which is a difference of two numbers up to 20
/// with some four roundings each.
const DISTANCE_ERROR: f64 = 2e-14;

/// Makes a problem from set to set whose distance is exact up to rounding.
fn known<M, const D: usize>(metric: M, ends: Ends<D>, distance: f64) -> Known<M, D> {
    Known { metric, ends, distance, distance_error: DISTANCE_ERROR }
}

/// Makes a problem from two points, if they are finite and the metric knows their distance.
fn between<M, const D: usize>(metric: M, [a, b]: [SVector<f64, D>; 2]) -> Option<Known<M, D>>
where
    M: Bounded<D> + KnownDistance<D>,
{
    Known::between(metric, a, b).expect("finite")
}

/// Draws problems between two random points under `metric`.
pub fn points<M, const D: usize>(
    metric: impl Strategy<Value = M>,
) -> impl Strategy<Value = Known<M, D>>
where
    M: Bounded<D> + KnownDistance<D> + Clone + Debug,
{
    (metric, two_points(2.5))
        .prop_filter_map("the distance is known", |(metric, ends)| between(metric, ends))
}

/// Makes ends that consist of a ball and the half-space `{normal·x ≥ offset}`.
fn ball_half_space<const D: usize>(
    ball: (SVector<f64, D>, f64),
    normal: impl Into<SVector<f64, D>>,
    offset: f64,
) -> Ends<D> {
    let ball = Ball::new(ball.0, ball.1).expect("a radius");
    let half_space = HalfSpace::at_least(normal, offset).expect("a normal");
    Ends::new(ball, half_space).expect("a ball is bounded")
}

/// Draws problems from a ball to a half-space under a constant metric.
pub fn constant_ball_half_space<const D: usize>() -> impl Strategy<Value = Known<Constant<D>, D>> {
    let sets = (vector::<D>(2.0), 0.0..1.0, two_points::<D>(1.0), 0.2..3.0);
    (matrix::<D>(), sets).prop_map(|(a, (centre, radius, [from, to], gap))| {
        let normal = to - from;
        let offset = normal.dot(&centre) + (radius + gap) * normal.norm();
        let inverse = a.try_inverse().expect("positive definite");
        let ends = ball_half_space((centre, radius), normal, offset);
        let distance = gap * normal.norm() / normal.dot(&(inverse * normal)).sqrt();
        let metric = Constant::new(a).expect("positive definite");
        known(metric, ends, distance)
    })
}

/// Draws problems with up to four points in each set. The pair that is nearest in the Euclidean
/// sense need not be the nearest one under `A`.
pub fn constant_finite_sets() -> impl Strategy<Value = Known<Constant<2>, 2>> {
    let points = || proptest::collection::vec(vector::<2>(2.0), 1..5);
    (constant::<2>(), points(), points()).prop_filter_map(
        "the sets are apart",
        |(metric, first, second)| {
            let pairs = first.iter().flat_map(|a| second.iter().map(move |b| (a, b)));
            let distance = pairs.map(|(a, b)| metric.distance(a, b).expect("known"));
            let distance = distance.fold(f64::INFINITY, f64::min);
            let set = |points| FiniteSet::new::<SVector<f64, 2>>(points).expect("not empty");
            let ends = Ends::new(set(first), set(second)).expect("bounded");
            (distance >= 0.03).then(|| known(metric, ends, distance))
        },
    )
}

/// Draws problems from a ball to a half-plane `{x₂ ≥ b}` under a shear.
pub fn shear_ball_half_plane() -> impl Strategy<Value = Known<Shear, 2>> {
    (shear(), vector(2.0), 0.0..1.0, 0.2..4.0).prop_map(|(metric, centre, radius, gap)| {
        let wall = centre[1] + radius + gap;
        known(metric, ball_half_space((centre, radius), [0.0, 1.0], wall), gap)
    })
}

/// Draws the first box of a pair by its centre and half-widths.
fn axis_box<const D: usize>() -> impl Strategy<Value = AxisBox<D>> {
    (vector(1.5), proptest::array::uniform::<_, D>(0.0..1.0))
        .prop_map(|(centre, half)| AxisBox::new(centre, half).expect("half-widths"))
}

/// Draws problems from a box to a half-space `{xᵢ ≥ b}` under a separable metric.
pub fn separable_box_half_space<const D: usize>() -> impl Strategy<Value = Known<Separable<D>, D>> {
    (separable(), axis_box(), 0..D, 0.2..4.0).prop_map(
        |(metric, first, axis, gap): (Separable<D>, AxisBox<D>, _, _)| {
            let from = *first.upper();
            let mut to = from;
            to[axis] += gap;
            let mut normal = SVector::zeros();
            normal[axis] = 1.0;
            let second = HalfSpace::at_least(normal, to[axis]).expect("a normal");
            let distance = metric.flatten(&to)[axis] - metric.flatten(&from)[axis];
            known(metric, Ends::new(first, second).expect("a box is bounded"), distance)
        },
    )
}

/// Draws problems from a box to a box under a separable metric.
pub fn separable_boxes<const D: usize>() -> impl Strategy<Value = Known<Separable<D>, D>> {
    (separable(), axis_box(), axis_box(), two_points::<D>(4.0)).prop_filter_map(
        "the boxes are apart",
        |(metric, first, second, [from, to]): (Separable<D>, AxisBox<D>, AxisBox<D>, _)| {
            let shift = to - from;
            let second =
                AxisBox::from_corners(second.lower() + shift, second.upper() + shift).ok()?;
            let [near, far] = [&first, &second]
                .map(|set| (metric.flatten(set.lower()), metric.flatten(set.upper())));
            let gap = SVector::<f64, D>::from_fn(|i, _| {
                (far.0[i] - near.1[i]).max(near.0[i] - far.1[i]).max(0.0)
            });
            let distance = gap.norm();
            let ends = Ends::new(first, second).expect("a box is bounded");
            (distance >= 0.2).then(|| known(metric, ends, distance))
        },
    )
}

/// Draws problems over the valleys along `x₁`, across up to two ridges.
pub fn valleys_along() -> impl Strategy<Value = Known<Valleys, 2>> {
    (-3.0..3.0, -2.0..2.0, 0.2..13.0)
        .prop_filter_map("along x₁", |(a, x2, length): (f64, _, _)| {
            between(Valleys, [[a, x2].into(), [a + length, x2].into()])
        })
}

/// Draws problems over the valleys between two points whose distance follows from Clairaut's
/// relation.
pub fn valleys_across<const D: usize>() -> impl Strategy<Value = Known<Valleys, D>> {
    points(Just(Valleys))
}

/// Returns `F(x₁)`, where `F′ = f = 2 − cos x₁`. Since `u(x) = F(x₁)` satisfies `|∇u| = f`, no
/// curve from `x` to `y` is shorter than `u(y) − u(x)`.
fn climb(x1: f64) -> f64 {
    2.0 * x1 - x1.sin()
}

/// Draws problems over the valleys from a ball to a half-plane `{x₁ ≥ b}`.
pub fn valleys_ball_half_space() -> impl Strategy<Value = Known<Valleys, 2>> {
    (vector::<2>(3.0), 0.0..1.5, 0.2..8.0).prop_map(|(centre, radius, gap)| {
        let (from, to) = (centre[0] + radius, centre[0] + radius + gap);
        let ends = ball_half_space((centre, radius), [1.0, 0.0], to);
        known(Valleys, ends, climb(to) - climb(from))
    })
}
