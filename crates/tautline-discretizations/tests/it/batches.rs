//! Integrals over a curve in batches, and point by point.

use nalgebra::vector;
use tautline_discretizations::{Interpolation, PointSequence};
use tautline_formula::{Batches, Plain, Prepared};
use tautline_metrics::{
    Metric,
    gallery::{Bump, GaussianFisher, Valleys},
    quadrature::Integral,
};

/// Compares energy and length on grids that fill a part of a batch, one batch, and several.
fn compare<M: Metric<2>>(metric: M, [from, to]: [[f64; 2]; 2]) {
    let prepared = Prepared::new(&metric);
    assert!(prepared.formula().is_some(), "the program is what is tested");
    let plain = Plain::new(&metric);
    for n in [1, 2, 3, 17, 18, 19, 100, 1001] {
        let bent = (0..=n).map(|k| {
            let s = k as f64 / n as f64;
            let line = vector![from[0], from[1]] * (1.0 - s) + vector![to[0], to[1]] * s;
            line + vector![0.1, -0.2] * (s * (1.0 - s))
        });
        let sequence = PointSequence::new(bent.collect()).expect("finite");
        let curve = Interpolation::new(&sequence);
        let pairs = |batches: &dyn Batches<2>| {
            [
                (curve.energy(&metric), curve.energy_by_batches(batches)),
                (curve.length(&metric), curve.length_by_batches(batches)),
            ]
        };
        for (by_points, by_batches) in pairs(&plain) {
            let bits = |Integral { value, error }| [f64::to_bits(value), f64::to_bits(error)];
            assert_eq!(bits(by_batches), bits(by_points), "N = {n}");
        }
        // A program and the compiled formula differ by a few roundings at each node.
        for (by_points, by_batches) in pairs(&prepared) {
            let difference = (by_batches.value - by_points.value).abs();
            assert!(difference <= 64.0 * f64::EPSILON * by_points.value, "N = {n}: {difference:e}");
        }
    }
}

/// On the coarse grids the first nodes do not resolve the metric, so that chords are halved.
#[test]
fn curves_are_integrated_in_batches_as_point_by_point() {
    compare(Valleys, [[-9.0, 0.0], [14.0, 3.0]]);
    compare(GaussianFisher, [[-2.0, 0.3], [2.0, 4.0]]);
    compare(Bump::new(30.0, 0.5).expect("a height"), [[-8.0, -1.0], [8.0, 1.0]]);
}
