//! Section 3: metrics, their geodesics and distances.

use proptest::prelude::*;
use tautline::{Bounded, Jet2, KnownDistance, Metric, SVector, gallery::Shear};

use crate::{
    families::{constant, ramp, separable, shear},
    random::{Verdict, at_most, for_all, two_points},
};

/// Proposition 3.1: a geodesic has constant speed; that of a minimal one over `[0, 1]` is `d`.
#[test]
fn prop_3_1_minimal_geodesics_of_shears_have_the_speed_d() {
    for_all(3001, 256, (shear(), two_points(2.5), 0.0..1.0), |(metric, [a, b], t)| {
        let [at, velocity, _] = geodesic(&metric, [a, b], t);
        let distance = metric.distance(&a, &b).expect("known");
        let speed = metric.norm_squared(&at, &velocity).sqrt();
        // Numbers up to 10, a dozen roundings, and d ≥ 0.1 is a difference of them.
        prop_assert!((speed - distance).abs() <= 1e-13, "{speed} is not {distance}");
        Ok(())
    });
}

/// Returns the minimal geodesic of a shear at the time `t`, its velocity and acceleration.
///
/// It is straight in flat coordinates; the way back from these is a formula over [`Scalar`], so
/// that a jet in `t` gives the derivatives.
///
/// [`Scalar`]: tautline::Scalar
fn geodesic(metric: &Shear, [a, b]: [SVector<f64, 2>; 2], t: f64) -> [SVector<f64, 2>; 3] {
    let (p, q) = (metric.flatten(&a), metric.flatten(&b));
    let [t] = Jet2::variables(&[t]);
    let flat = SVector::<Jet2<f64, 1>, 2>::from_fn(|i, _| t * (q[i] - p[i]) + p[i]);
    let curve = metric.unflatten(&flat);
    [curve.map(|x| x.value()), curve.map(|x| x.first(0)), curve.map(|x| x.second(0, 0))]
}

fn distance_is_squeezed<M, const D: usize>(metric: &M, [a, b]: [SVector<f64, D>; 2]) -> Verdict
where
    M: Bounded<D> + KnownDistance<D>,
{
    let constants = metric.constants();
    let d2 = metric.distance(&a, &b).expect("known").powi(2);
    let euclidean = (b - a).norm_squared();
    // As in the test above.
    let slack = 1e-12 * (d2 + euclidean);
    at_most("c₁|x − y|² ≤ d²", constants.c1() * euclidean, d2, slack)?;
    at_most("d² ≤ c₂|x − y|²", d2, constants.c2() * euclidean, slack)
}

/// Proposition 3.3: `c₁|x − y|² ≤ d(x, y)² ≤ c₂|x − y|²`.
#[test]
fn prop_3_3_distances_lie_between_the_euclidean_ones() {
    for_all(3301, 256, (shear(), two_points(2.5)), |(m, x)| distance_is_squeezed(&m, x));
    for_all(3302, 256, (ramp(), two_points(2.5)), |(m, x)| distance_is_squeezed(&m, x));
    for_all(3303, 256, (separable::<3>(), two_points(2.5)), |(m, x)| distance_is_squeezed(&m, x));
    for_all(3304, 256, (constant::<3>(), two_points(2.5)), |(m, x)| distance_is_squeezed(&m, x));
}
