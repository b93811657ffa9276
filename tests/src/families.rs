//! Random metrics whose distance is known exactly, and pairs of sets at a known distance.
//!
//! | metric | sets | `d` |
//! | --- | --- | --- |
//! | constant `A` | points | `∣A^{1/2} (x − y)∣` |
//! | | ball about `c`, half-space `{a·x ≥ b}` | `(b − a·c − r∣a∣) / (aᵀA⁻¹a)^{1/2}` |
//! | shear | points | `∣Φ(x) − Φ(y)∣` |
//! | | ball, half-plane `{x₂ ≥ b}` | `b − c₂ − r`, since `Φ` keeps `x₂` |
//! | separable | points | `∣F(x) − F(y)∣` |
//! | | box, box | that of the boxes `F` maps them to, boxes again |
//! | ramp | points | `∣F(x) − F(y)∣` |
//! | valleys | points along `x₁` | `F(b) − F(a)` |
//! | | points across | by Clairaut's relation, where it has a solution |
//! | | ball, half-space `{x₁ ≥ b}` | `F(b) − F(c₁ + r)`, since `∣∇F(x₁)∣ = f` everywhere |

use std::fmt::Debug;

use proptest::prelude::*;
use tautline::{
    AxisBox, Ball, Bounded, Ends, HalfSpace, KnownDistance, SMatrix, SVector,
    gallery::{Constant, Ramp, Separable, Shear, Valleys},
};

use crate::random::{two_points, vector};

/// A metric, two sets, and their distance in `m`.
#[derive(Clone, Debug)]
pub(crate) struct Known<M, const D: usize> {
    pub(crate) metric: M,
    pub(crate) ends: Ends<D>,
    pub(crate) distance: f64,
}

impl<M: Bounded<D>, const D: usize> Known<M, D> {
    fn between(metric: M, [a, b]: [SVector<f64, D>; 2]) -> Option<Self>
    where
        M: KnownDistance<D>,
    {
        let distance = metric.distance(&a, &b)?;
        Some(Self { metric, ends: Ends::points(a, b).expect("finite"), distance })
    }
}

/// A symmetric positive definite matrix: `MᵀM + ¼ I` with entries of `M` in `[−1, 1]`.
fn matrix<const D: usize>() -> impl Strategy<Value = SMatrix<f64, D, D>> {
    let entries = proptest::array::uniform::<_, D>(vector::<D>(1.0));
    entries.prop_map(|columns| {
        let m: SMatrix<f64, D, D> = SMatrix::from_columns(&columns);
        let square: SMatrix<f64, D, D> = m.tr_mul(&m) + SMatrix::identity() * 0.25;
        (square + square.transpose()) * 0.5
    })
}

pub(crate) fn constant<const D: usize>() -> impl Strategy<Value = Constant<D>> {
    matrix().prop_map(|a| Constant::new(a).expect("positive definite"))
}

pub(crate) fn shear() -> impl Strategy<Value = Shear> {
    (-0.8..0.8, 0.5..2.0)
        .prop_map(|(amplitude, k)| Shear::new(amplitude, k).expect("a positive wave number"))
}

pub(crate) fn separable<const D: usize>() -> impl Strategy<Value = Separable<D>> {
    let wave_numbers = proptest::array::uniform::<_, D>(0.5..2.0);
    (vector(0.6), wave_numbers).prop_map(|(amplitudes, k): (SVector<f64, D>, _)| {
        Separable::new(amplitudes, k).expect("amplitudes below one")
    })
}

pub(crate) fn ramp() -> impl Strategy<Value = Ramp> {
    (-0.7..0.7, 0.5..2.0).prop_map(|(amplitude, k)| Ramp::new(amplitude, k).expect("below one"))
}

/// `metric` between two random points.
pub(crate) fn points<M, const D: usize>(
    metric: impl Strategy<Value = M>,
) -> impl Strategy<Value = Known<M, D>>
where
    M: Bounded<D> + KnownDistance<D> + Clone + Debug,
{
    (metric, two_points(2.5))
        .prop_filter_map("the distance is known", |(metric, ends)| Known::between(metric, ends))
}

pub(crate) fn constant_ball_half_space<const D: usize>()
-> impl Strategy<Value = Known<Constant<D>, D>> {
    let sets = (vector::<D>(2.0), 0.0..1.0, two_points::<D>(1.0), 0.2..3.0);
    (matrix::<D>(), sets).prop_map(|(a, (centre, radius, [from, to], gap))| {
        let normal = to - from;
        let offset = normal.dot(&centre) + (radius + gap) * normal.norm();
        let inverse = a.try_inverse().expect("positive definite");
        Known {
            metric: Constant::new(a).expect("positive definite"),
            ends: Ends::new(
                Ball::new(centre, radius).expect("a radius"),
                HalfSpace::at_least(normal, offset).expect("a normal"),
            )
            .expect("a ball is bounded"),
            distance: gap * normal.norm() / normal.dot(&(inverse * normal)).sqrt(),
        }
    })
}

pub(crate) fn shear_ball_half_plane() -> impl Strategy<Value = Known<Shear, 2>> {
    (shear(), vector(2.0), 0.0..1.0, 0.2..4.0).prop_map(|(metric, centre, radius, gap)| Known {
        metric,
        ends: Ends::new(
            Ball::new(centre, radius).expect("a radius"),
            HalfSpace::at_least([0.0, 1.0], centre[1] + radius + gap).expect("a normal"),
        )
        .expect("a ball is bounded"),
        distance: gap,
    })
}

/// The first box of a pair, from its centre and half-widths.
fn axis_box<const D: usize>() -> impl Strategy<Value = AxisBox<D>> {
    (vector(1.5), proptest::array::uniform::<_, D>(0.0..1.0))
        .prop_map(|(centre, half)| AxisBox::new(centre, half).expect("half-widths"))
}

pub(crate) fn separable_boxes<const D: usize>() -> impl Strategy<Value = Known<Separable<D>, D>> {
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
            (distance >= 0.2).then_some(Known { metric, ends, distance })
        },
    )
}

pub(crate) fn valleys_along() -> impl Strategy<Value = Known<Valleys, 2>> {
    // Up to two ridges.
    (-3.0..3.0, -2.0..2.0, 0.2..13.0).prop_filter_map(
        "along x₁",
        |(a, x2, length): (f64, _, _)| {
            Known::between(Valleys, [[a, x2].into(), [a + length, x2].into()])
        },
    )
}

pub(crate) fn valleys_across<const D: usize>() -> impl Strategy<Value = Known<Valleys, D>> {
    points(Just(Valleys))
}

/// `F` with `F′ = f = 2 − cos x₁`: `u(x) = F(x₁)` has `|∇u| = f`, so that no curve from `x` to `y`
/// is shorter than `u(y) − u(x)`.
fn climb(x1: f64) -> f64 {
    2.0 * x1 - x1.sin()
}

pub(crate) fn valleys_ball_half_space() -> impl Strategy<Value = Known<Valleys, 2>> {
    (vector::<2>(3.0), 0.0..1.5, 0.2..8.0).prop_map(|(centre, radius, gap)| {
        let (from, to) = (centre[0] + radius, centre[0] + radius + gap);
        Known {
            metric: Valleys,
            ends: Ends::new(
                Ball::new(centre, radius).expect("a radius"),
                HalfSpace::at_least([1.0, 0.0], to).expect("a normal"),
            )
            .expect("a ball is bounded"),
            distance: climb(to) - climb(from),
        }
    })
}
