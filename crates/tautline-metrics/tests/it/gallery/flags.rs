//! What constants say beside their numbers: that a metric is a multiple of the identity, and that
//! they hold on a region only.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_metrics::{
    Bounded, LocallyBounded, Metric,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{
        Bump, Checkerboard, Constant, Corrugated, EggCrate, GaussianFisher, GaussianFisherPatch,
        Hyperbolic, HyperbolicPatch, Lens, Obstacle, Ramp, RotatingAnisotropy, Separable, Shear,
        SineProjections, SoftObstacles, Sphere, SpherePatch, Swirl, TwoChannels, Valleys,
    },
};

/// Whether `H` is a multiple of the identity at some points near the origin.
fn looks_isotropic<const D: usize>(g: &impl Metric<D>) -> bool {
    (0..40).all(|k| {
        let x = SVector::from_fn(|i, _| 0.3 * (f64::from(k) * (1.0 + i as f64).sqrt()).sin());
        let h: SMatrix<f64, D, D> = g.gram(&x);
        // The rounding of entries written in several ways.
        (h - SMatrix::identity() * h[(0, 0)]).amax() <= 1e-14 * h[(0, 0)]
    })
}

#[track_caller]
fn everywhere<const D: usize>(g: &impl Bounded<D>, isotropic: bool) {
    assert_eq!(looks_isotropic(g), isotropic);
    assert_eq!(g.constants().is_isotropic(), isotropic);
    assert!(!g.constants().is_local());
}

#[track_caller]
fn on_balls<const D: usize>(g: &impl LocallyBounded<D>, isotropic: bool) {
    assert_eq!(looks_isotropic(g), isotropic);
    for radius in [0.0, 0.25] {
        let found = g.constants_within(&SVector::repeat(0.1), radius).expect("inside");
        assert_eq!(found.is_isotropic(), isotropic);
        assert!(found.is_local() && found.m_h().is_some());
    }
}

#[test]
fn isotropic_metrics_say_so_and_the_others_do_not() {
    everywhere::<3>(&Valleys, true);
    everywhere::<2>(&Lens::new(2.0, 0.7).expect("positive"), true);
    everywhere::<2>(&Bump::new(2.0, 0.7).expect("positive"), true);
    everywhere::<1>(&Ramp::new(0.5, 1.3).expect("|a| < 1"), true);
    everywhere(&Checkerboard::new(2.0, 0.7).expect("positive"), true);
    everywhere(&TwoChannels::new(2.0, 0.5, 0.7).expect("positive"), true);
    everywhere::<2>(&SpherePatch::new(0.5).expect("positive"), true);
    everywhere::<2>(&HyperbolicPatch::new(0.5).expect("positive"), true);
    let centre = vector![0.2, 0.1];
    let obstacles = SoftObstacles::new(vec![Obstacle { centre, height: 2.0, width: 0.5 }]);
    everywhere(&obstacles.expect("positive"), true);
    everywhere(&Shear::new(0.5, 1.0).expect("k > 0"), false);
    everywhere(&Swirl::new(0.5, 1.0).expect("s > 0"), false);
    everywhere(&EggCrate::new(0.5, 1.0).expect("k > 0"), false);
    everywhere::<2>(&Corrugated::new(0.5, 1.0).expect("k > 0"), false);
    everywhere(&GaussianFisherPatch::new(0.5).expect("positive"), false);
    everywhere(&Separable::new([0.5, 0.2], [1.0, 2.0]).expect("|a| < 1"), false);
    everywhere(&RotatingAnisotropy::new([1.0, 2.0], [1.0, 2.0]).expect("positive"), false);
    everywhere(&SineProjections::benchmark(), false);
}

#[test]
fn constants_on_balls_are_local_and_lose_nothing_else() {
    on_balls::<2>(&Sphere, true);
    on_balls::<3>(&Hyperbolic, true);
    on_balls(&GaussianFisher, false);
    on_balls(&Constant::new(matrix![2.0, 0.5; 0.5, 1.0]).expect("definite"), false);
    on_balls::<2>(&&Sphere, true);
    on_balls::<2>(&Scaled::new(Sphere, 3.0).expect("positive"), true);
    on_balls::<2>(&Sum::new(Sphere, Hyperbolic), true);
    on_balls(&Sum::new(Sphere, GaussianFisher), false);
    on_balls(&Sum::new(GaussianFisher, Sphere), false);
    on_balls::<4>(&Product::<_, _, 2, 2>::new(Sphere, GaussianFisher), false);
    let slanted = AffinePullback::new(Sphere, matrix![1.0, 0.5; 0.0, 1.0], [0.1, 0.0]);
    on_balls(&slanted.expect("invertible"), false);
}

/// Halves that differ by rounding become one.
#[test]
fn a_constant_metric_is_symmetric_to_the_last_bit() {
    let next = 0.5_f64.next_up();
    let g = Constant::new(matrix![2.0, 0.5; next, 1.0]).expect("symmetric up to rounding");
    let h: SMatrix<f64, 2, 2> = g.gram(&vector![0.0, 0.0]);
    assert_eq!(h, matrix![2.0, 0.5; 0.5, 1.0]);
}
