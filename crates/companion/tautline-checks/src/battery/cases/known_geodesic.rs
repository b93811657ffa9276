//! Known geodesics: between any two points, and the one from which several counterexamples start.

use nalgebra::SVector;
use tautline::gallery::Shear;
use tautline_statements::{
    Known,
    curves::{Geodesic, KnownGeodesics},
};

/// Returns a known minimal geodesic between two points, and their distance.
pub(crate) fn known_geodesic<M: KnownGeodesics<D>, const D: usize>(
    metric: M,
    ends: [SVector<f64, D>; 2],
) -> (Geodesic<M, D>, f64) {
    let distance = metric.distance(&ends[0], &ends[1]).expect("known");
    (Geodesic::between(metric, ends), distance)
}

/// Returns the geodesic of a shear from `(0, 0)` to `(2, 3)`.
pub(crate) fn sheared() -> (Known<Shear, 2>, Geodesic<Shear, 2>) {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    let ends = [[0.0, 0.0].into(), [2.0, 3.0].into()];
    let known = Known::joined(shear, ends).expect("finite").expect("known");
    (known, Geodesic::between(shear, ends))
}
