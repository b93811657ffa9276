//! Every metric of the gallery that has constants: one line each. `Sphere` and `Hyperbolic`
//! have none; what applies to them is in `without_constants.rs`.
//!
//! The regions hold the points where the constants are attained: a period, or six widths to each
//! side, where a Gaussian is below `10⁻⁷`, or a patch with what surrounds it.

use std::f64::consts::TAU;

use tautline::gallery::{
    Bump, Checkerboard, Constant, Corrugated, CoupledCosines, EggCrate, GaussianFisherPatch, Hill,
    HyperbolicPatch, Lens, Obstacle, Ramp, RotatingAnisotropy, Separable, Shear, SineProjections,
    SoftObstacles, SpherePatch, Swirl, TanhDecoder, TwoChannels, TwoLinkArm, Valleys,
};
use tautline_kit::prelude::*;

/// The cube `[−size, size]^D`.
pub(super) fn cube<const D: usize>(size: f64) -> Region<D> {
    Region::cell([-size; D], [size; D])
}

/// The cube `[0, 2π]^D`.
pub(super) fn period<const D: usize>() -> Region<D> {
    Region::cell([0.0; D], [TAU; D])
}

fn constant() -> Constant<2> {
    Constant::new(SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0)).expect("positive definite")
}

pub(super) fn ramp() -> Ramp {
    Ramp::new(0.5, 1.0).expect("below one")
}

pub(super) fn separable() -> Separable<3> {
    Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("below one")
}

pub(super) fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("a wave number")
}

pub(super) fn lens() -> Lens {
    Lens::new(1.0, 0.5).expect("a width")
}

pub(super) fn bump() -> Bump {
    Bump::new(1.0, 0.5).expect("a width")
}

pub(super) fn hill() -> Hill {
    Hill::new(0.5, 0.5).expect("a width")
}

fn obstacles() -> SoftObstacles<2> {
    let one = Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 };
    let two = Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 };
    SoftObstacles::new(vec![one, two]).expect("widths")
}

pub(super) fn anisotropy() -> RotatingAnisotropy {
    RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]).expect("eigenvalues")
}

pub(super) fn arm() -> TwoLinkArm {
    TwoLinkArm::new(4.0, 0.8, 1.0).expect("positive definite")
}

pub(super) fn swirl() -> Swirl {
    Swirl::new(1.0, 0.5).expect("a width")
}

pub(super) fn egg_crate() -> EggCrate {
    EggCrate::new(0.5, 1.0).expect("a wave number")
}

pub(super) fn corrugated() -> Corrugated {
    Corrugated::new(0.5, 1.0).expect("a wave number")
}

pub(super) fn checkerboard() -> Checkerboard {
    Checkerboard::new(2.0, 1.0).expect("a side")
}

pub(super) fn channels() -> TwoChannels {
    TwoChannels::new(2.0, 1.0, 0.5).expect("a width")
}

/// A hemisphere; its constants are attained at the centre, in it and outside.
pub(super) fn sphere_patch() -> SpherePatch {
    SpherePatch::new(1.0).expect("a radius")
}

pub(super) fn hyperbolic_patch() -> HyperbolicPatch {
    HyperbolicPatch::new(0.5).expect("below 0.86")
}

pub(super) fn fisher() -> GaussianFisherPatch {
    GaussianFisherPatch::new(0.75).expect("a rim")
}

pub(super) fn decoder() -> TanhDecoder<2, 3, 3> {
    let inner = SMatrix::<f64, 3, 2>::new(1.0, 0.2, -0.5, 0.8, 0.3, -1.0);
    let outer = SMatrix::<f64, 3, 3>::new(1.0, 0.0, 0.5, 0.0, 1.0, -0.5, 0.4, 0.3, 1.0);
    TanhDecoder::new(inner, outer, 0.5).expect("a floor")
}

metric_suite!(a_constant_matrix: constant(), dimension 2, in cube(2.0), with distances);
metric_suite!(valleys_on_a_line: Valleys, dimension 1, in period(), with distances);
metric_suite!(valleys: Valleys, dimension 2, in period(), with distances);
metric_suite!(a_ramp: ramp(), dimension 1, in cube(8.0), with distances);
metric_suite!(a_separable_metric: separable(), dimension 3, in cube(3.2), with distances);
metric_suite!(a_shear: shear(), dimension 2, in period(), with distances);
metric_suite!(a_lens: lens(), dimension 2, in cube(3.0), with distances);
metric_suite!(a_bump: bump(), dimension 2, in cube(3.0), with distances);
metric_suite!(a_hill: hill(), dimension 2, in cube(3.0), with distances);
metric_suite!(soft_obstacles: obstacles(), dimension 2, in cube(3.0));
metric_suite!(rotating_anisotropy: anisotropy(), dimension 2, in cube(2.0));
metric_suite!(a_two_link_arm: arm(), dimension 2, in period());
metric_suite!(coupled_cosines: CoupledCosines, dimension 3, in period());
metric_suite!(sine_projections: SineProjections::benchmark(), dimension 8, in cube(1.5));
metric_suite!(a_swirl: swirl(), dimension 2, in cube(3.0), with distances);
metric_suite!(an_egg_crate: egg_crate(), dimension 2, in period(), with distances);
metric_suite!(a_corrugated_sheet: corrugated(), dimension 2, in period(), with distances);
metric_suite!(a_checkerboard: checkerboard(), dimension 2, in cube(1.5), with distances);
metric_suite!(two_channels: channels(), dimension 2, in cube(3.0), with distances);
metric_suite!(a_patch_of_the_sphere: sphere_patch(), dimension 2, in cube(2.0), with distances);
metric_suite!(
    a_patch_of_hyperbolic_space: hyperbolic_patch(), dimension 2, in cube(1.0), with distances,
);
metric_suite!(
    normal_distributions: fisher(), dimension 2, in Region::cell([-2.0, -1.5], [2.0, 1.5]),
    with distances,
);
metric_suite!(a_tanh_decoder: decoder(), dimension 2, in cube(6.0));
