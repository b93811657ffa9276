//! Every metric of the gallery that has constants. `Sphere`, `Hyperbolic` and `GaussianFisher` have
//! constants on balls only, see `without_constants.rs`.
//!
//! The regions hold the points where the constants are attained: a period, or six widths to each
//! side, where a Gaussian is below `10⁻⁷`, or a patch and its surroundings.

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

fn obstacles() -> SoftObstacles<2> {
    let one = Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 };
    let two = Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 };
    SoftObstacles::new(vec![one, two]).expect("widths")
}

pub(super) fn decoder() -> TanhDecoder<2, 3, 3> {
    let inner = SMatrix::<f64, 3, 2>::new(1.0, 0.2, -0.5, 0.8, 0.3, -1.0);
    let outer = SMatrix::<f64, 3, 3>::new(1.0, 0.0, 0.5, 0.0, 1.0, -0.5, 0.4, 0.3, 1.0);
    TanhDecoder::new(inner, outer, 0.5).expect("a floor")
}

/// Names the metrics that several tests use.
macro_rules! metrics {
    ($($(#[$doc:meta])* $name:ident: $metric:ty = $new:expr;)*) => {
        $($(#[$doc])* pub(super) fn $name() -> $metric { $new.expect("valid") })*
    };
}

metrics! {
    ramp: Ramp = Ramp::new(0.5, 1.0);
    separable: Separable<3> = Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]);
    shear: Shear = Shear::new(0.5, 1.0);
    lens: Lens = Lens::new(1.0, 0.5);
    bump: Bump = Bump::new(1.0, 0.5);
    hill: Hill = Hill::new(0.5, 0.5);
    anisotropy: RotatingAnisotropy = RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]);
    arm: TwoLinkArm = TwoLinkArm::new(4.0, 0.8, 1.0);
    swirl: Swirl = Swirl::new(1.0, 0.5);
    egg_crate: EggCrate = EggCrate::new(0.5, 1.0);
    corrugated: Corrugated = Corrugated::new(0.5, 1.0);
    checkerboard: Checkerboard = Checkerboard::new(2.0, 1.0);
    channels: TwoChannels = TwoChannels::new(2.0, 1.0, 0.5);
    /// A hemisphere. Its constants are attained at the centre, at the rim and outside.
    sphere_patch: SpherePatch = SpherePatch::new(1.0);
    hyperbolic_patch: HyperbolicPatch = HyperbolicPatch::new(0.5);
    fisher: GaussianFisherPatch = GaussianFisherPatch::new(0.75);
}

metric_suite!(
    a_constant_matrix: Constant::new(SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0)), dimension 2,
    in cube(2.0), with distances,
);
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
