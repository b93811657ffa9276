//! Every metric of the gallery with constants: one line each.
//!
//! The regions hold the points where the constants are attained: a period, or six widths to each
//! side, where a Gaussian is below `10⁻⁷`.

use std::f64::consts::TAU;

use tautline::gallery::{
    Bump, Constant, CoupledCosines, Hill, Lens, Obstacle, Ramp, RotatingAnisotropy, Separable,
    Shear, SineProjections, SoftObstacles, TwoLinkArm, Valleys,
};
use tautline_verify::prelude::*;

/// The cube `[−size, size]^D`.
fn cube<const D: usize>(size: f64) -> Region<D> {
    Region::cell([-size; D], [size; D])
}

/// One period of the valleys, from valley to valley.
fn period<const D: usize>(length: f64) -> Region<D> {
    Region::cell([0.0; D], [length; D])
}

fn constant() -> Constant<2> {
    Constant::new(SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0)).expect("positive definite")
}

fn separable() -> Separable<3> {
    Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("below one")
}

fn obstacles() -> SoftObstacles<2> {
    let one = Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 };
    let two = Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 };
    SoftObstacles::new(vec![one, two]).expect("positive widths")
}

metric_suite!(constant_matrix: constant(), dimension 2, in cube(2.0), with distances);
metric_suite!(valleys_1: Valleys, dimension 1, in period(TAU), with distances);
metric_suite!(valleys_2: Valleys, dimension 2, in period(TAU), with distances);
metric_suite!(ramp: Ramp::new(0.5, 1.0).expect("below one"), dimension 1, in cube(8.0), with distances);
metric_suite!(separable_3: separable(), dimension 3, in cube(3.2), with distances);
metric_suite!(shear_2: Shear::new(0.5, 1.0).expect("valid"), dimension 2, in period(TAU), with distances);
metric_suite!(lens_2: Lens::new(1.0, 0.5).expect("valid"), dimension 2, in cube(3.0), with distances);
metric_suite!(bump_2: Bump::new(1.0, 0.5).expect("valid"), dimension 2, in cube(3.0), with distances);
metric_suite!(hill_2: Hill::new(0.5, 0.5).expect("valid"), dimension 2, in cube(3.0), with distances);
metric_suite!(soft_obstacles: obstacles(), dimension 2, in cube(3.0));
metric_suite!(rotating_anisotropy: RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]).expect("valid"), dimension 2, in cube(2.0));
metric_suite!(two_link_arm: TwoLinkArm::new(4.0, 0.8, 1.0).expect("definite"), dimension 2, in period(TAU));
metric_suite!(coupled_cosines: CoupledCosines, dimension 3, in period(TAU));
metric_suite!(sine_projections_8: SineProjections::benchmark(), dimension 8, in cube(1.5));
