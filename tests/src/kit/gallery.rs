//! Runs the suite on every sample of the gallery, and on two samples in higher dimensions. The
//! metrics that have constants only on balls are in `without_constants.rs`.

use std::f64::consts::TAU;

use tautline::gallery::*;
use tautline_kit::prelude::*;

/// Returns the cube `[−size, size]^D`.
pub(super) fn cube<const D: usize>(size: f64) -> Region<D> {
    Region::cell([-size; D], [size; D])
}

/// Returns the cube `[0, 2π]^D`.
pub(super) fn period<const D: usize>() -> Region<D> {
    Region::cell([0.0; D], [TAU; D])
}

pub(super) fn separable_in_space() -> Separable<3> {
    Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("below one")
}

macro_rules! suites {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in [$low:expr, $high:expr],
        exact $exact:expr $(, with $distances:ident)?;
    )*) => {$(
        metric_suite!($id: $metric, dimension $D, in Region::cell($low, $high) $(, with $distances)?);
    )*};
}

for_each_sample!(suites);

metric_suite!(
    a_separable_metric_in_space: separable_in_space(), dimension 3, in cube(3.2), with distances,
);
metric_suite!(
    sine_projections_in_eight_dimensions: SineProjections::benchmark(), dimension 8, in cube(1.5),
);
metric_suite!(
    rotating_anisotropy_against_an_axis: RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]),
    dimension 2, in cube(2.0),
);
