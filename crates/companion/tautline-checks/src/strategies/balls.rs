//! Random problems for metrics that have constants only on balls. The ends are so close together
//! that the ball contains all competitors.

use std::{fmt::Debug, num::NonZeroUsize};

use proptest::prelude::*;
use tautline::{
    Constants, KnownDistance, LocalError, LocallyBounded, SVector,
    bounds::{PaperRule, competitors},
    gallery::{GaussianFisher, Hyperbolic, Sphere},
};
use tautline_statements::{Known, WithConstants};

use super::points::vector;

/// Draws two points of the sphere, in stereographic coordinates.
pub fn sphere_nearby<const D: usize>() -> impl Strategy<Value = Known<WithConstants<Sphere>, D>> {
    nearby(Sphere, vector::<D>(1.5), 0.05..0.9)
}

/// Draws two points of hyperbolic space, in the unit ball.
pub fn hyperbolic_nearby<const D: usize>()
-> impl Strategy<Value = Known<WithConstants<Hyperbolic>, D>> {
    let centre = vector::<D>(1.0).prop_map(|x| x * (0.8 / (D as f64).sqrt()));
    nearby(Hyperbolic, centre, 0.02..0.15)
}

/// Draws two normal distributions, given by their means and the logarithms of their standard
/// deviations.
pub fn gaussian_fisher_nearby() -> impl Strategy<Value = Known<WithConstants<GaussianFisher>, 2>> {
    nearby(GaussianFisher, vector::<2>(2.0), 0.02..0.8)
}

/// Draws a point, a ball about it, and a second point so close that no competitor leaves the ball.
fn nearby<M, const D: usize>(
    metric: M,
    centre: impl Strategy<Value = SVector<f64, D>>,
    radius: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Known<WithConstants<M>, D>>
where
    M: LocallyBounded<D> + KnownDistance<D> + Copy + Debug,
{
    let direction = vector::<D>(1.0).prop_filter("a direction", |w| w.norm() > 0.1);
    let cases = (centre, radius, direction, 0.3..1.0);
    cases.prop_map(move |(a, radius, w, share)| {
        let constants = metric.constants_within(&a, radius).expect("inside of its domain");
        let b = a + w * (share * farthest::<D>(constants, radius) / w.norm());
        let known = Known::between(WithConstants { metric, constants }, a, b).expect("finite");
        known.expect("all distances are known")
    })
}

/// Returns the largest distance, in `ℓ` and to ten percent, that two points may have so that no
/// competitor moves farther than `radius` from one of them.
fn farthest<const D: usize>(constants: Constants, radius: f64) -> f64 {
    let everywhere = |_| Ok::<_, LocalError>(constants);
    let mut apart = radius;
    let stays = |apart: f64| {
        let upper = constants.c2().sqrt() * apart;
        PaperRule::BOTH.into_iter().all(|rule| {
            let region = competitors(D, rule, NonZeroUsize::MIN, upper, everywhere);
            region.is_ok_and(|region| region.radius <= radius)
        })
    };
    while !stays(apart) {
        apart *= 0.9;
    }
    apart
}
