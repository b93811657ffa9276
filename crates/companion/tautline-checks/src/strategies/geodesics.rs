//! Random curves: pairs of points joined by known geodesics, clocks, and rays.

use std::fmt::Debug;

use proptest::{prelude::*, sample::select};
use tautline::{
    KnownDistance, SVector,
    gallery::{Hyperbolic, Sphere},
    norm_squared,
};
use tautline_statements::{
    Known,
    curves::{Clock, KnownGeodesics, Pace},
};

use super::points::{two_points, vector};

/// Draws a metric with known geodesics, and two points.
pub fn joined<M, const D: usize>(
    metric: impl Strategy<Value = M>,
) -> impl Strategy<Value = (M, [SVector<f64, D>; 2])>
where
    M: KnownGeodesics<D> + Clone + Debug,
{
    (metric, two_points(2.5))
}

/// Draws the sphere and two points on the hemisphere opposite the missing point. Minimal geodesics
/// between two such points stay in this hemisphere.
pub fn on_sphere<const D: usize>() -> impl Strategy<Value = (Sphere, [SVector<f64, D>; 2])> {
    (Just(Sphere), two_points(0.95 / (D as f64).sqrt()))
}

/// Draws hyperbolic space and two points in the ball of radius 0.85 of its ball model.
pub fn in_hyperbolic_space<const D: usize>()
-> impl Strategy<Value = (Hyperbolic, [SVector<f64, D>; 2])> {
    (Just(Hyperbolic), two_points(0.85 / (D as f64).sqrt()))
}

/// Draws a clock that never runs backwards. It has up to five pieces, whose durations lie within a
/// factor of 20; one piece in three is a pause.
pub fn clock() -> impl Strategy<Value = Clock> {
    let pieces = proptest::collection::vec((0.05..1.0, 0.0..1.0, 0..3_u8), 1..6);
    let paces = select(vec![Pace::Even, Pace::Accelerating, Pace::Smooth]);
    (pieces, paces).prop_map(|(pieces, pace)| {
        let durations: Vec<f64> = pieces.iter().map(|piece| piece.0).collect();
        let steps: Vec<f64> =
            pieces.iter().map(|&(_, way, rests)| if rests == 0 { 0.0 } else { way }).collect();
        // The last piece always ends at the reading 1.
        let total: f64 = steps.iter().sum::<f64>() + 0.1;
        let mut reading = 0.0;
        let mut readings = Vec::new();
        for step in &steps[..steps.len() - 1] {
            reading += step / total;
            readings.push(reading);
        }
        Clock::new(&durations, &readings, pace).expect("positive durations")
    })
}

/// Draws a radial metric and two points on one ray, up to 4 from its centre; the widths of the
/// metrics are from 0.5 to 2.
pub fn ray<M, const D: usize>(
    metric: impl Strategy<Value = M>,
) -> impl Strategy<Value = Known<M, D>>
where
    M: KnownDistance<D> + Clone + Debug,
{
    let points = (vector::<D>(1.0), 0.05..2.0, 0.1..2.0)
        .prop_filter("a direction", |(direction, ..)| direction.norm() >= 0.1);
    (metric, points).prop_filter_map("on a ray", |(metric, (direction, from, gap))| {
        let at = |radius: f64| direction * (radius / direction.norm());
        segment(metric, [at(from), at(from + gap)])
    })
}

/// Makes a problem from two points. The segment between them is minimal if the metric knows their
/// distance.
fn segment<M: KnownDistance<D>, const D: usize>(
    metric: M,
    [a, b]: [SVector<f64, D>; 2],
) -> Option<Known<M, D>> {
    let ends = tautline::Ends::points(a, b).expect("finite");
    let distance = metric.distance(&a, &b)?;
    // The distance is a sum of a few quadratures, each accurate to 1e-15.
    let distance_error = 1e-14 * (distance + norm_squared(&metric, &a, &a).sqrt());
    Some(Known { metric, ends, distance, distance_error })
}
