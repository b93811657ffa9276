//! Compositions of metrics with constants on balls: their constants hold and follow from those of
//! the parts on their own balls.

use nalgebra::{SMatrix, SVector, vector};
use proptest::prelude::*;
use tautline_metrics::{
    Bounded, Constants, LocallyBounded,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{Constant, GaussianFisher, Hyperbolic, Sphere},
};

use crate::{
    about::{About, in_ball},
    laws::{constants_hold, cube},
};

fn ball<const D: usize>() -> impl Strategy<Value = (SVector<f64, D>, f64)> {
    (cube::<D>(), 0.01..1.0_f64)
}

fn on_ball<M: LocallyBounded<D>, const D: usize>(
    metric: M,
    centre: SVector<f64, D>,
    radius: f64,
) -> (About<M, D>, f64) {
    (About::new(metric, centre, radius), in_ball::<D>(radius))
}

constants_hold! {
    constants_of_scaled_hold_on_balls, 2, seed 111: (ball::<2>(), 0.01..100.0_f64),
        |((centre, radius), factor)| {
            on_ball(Scaled::new(Sphere, factor).expect("positive"), centre, radius)
        };
    constants_of_sum_hold_on_balls, 2, seed 112: ball::<2>(), |(centre, radius)| {
        on_ball(Sum::new(Sphere, GaussianFisher), centre, radius)
    };
    constants_of_product_hold_on_balls, 4, seed 113: ball::<4>(), |(centre, radius)| {
        on_ball(Product::<_, _, 2, 2>::new(Sphere, GaussianFisher), centre, radius)
    };
    constants_of_affine_pullback_hold_on_balls, 2, seed 114:
        (ball::<2>(), proptest::array::uniform::<_, 4>(-1.0..1.0_f64), cube::<2>()),
        |((centre, radius), entries, shift)| {
            let matrix =
                SMatrix::<f64, 2, 2>::from_column_slice(&entries) + SMatrix::identity() * 2.0;
            let metric = AffinePullback::new(Sphere, matrix, shift).expect("regular");
            on_ball(metric, centre, radius)
        };
}

/// Applies the calculus of constants to those of the parts on their own balls.
#[test]
fn constants_on_balls_are_those_of_the_parts() {
    fn of<M: LocallyBounded<D>, const D: usize>(metric: M, x: [f64; D], radius: f64) -> Constants {
        metric.constants_within(&x.into(), radius).expect("inside")
    }
    let (x, radius) = ([0.3, 0.1], 0.2);
    let sphere = of(Sphere, x, radius);
    let scaled = Scaled::new(Sphere, 3.0).expect("positive");
    assert_eq!(of(scaled, x, radius), sphere.scaled(3.0).expect("in range"));
    let sum = sphere.plus(of(Hyperbolic, x, radius)).expect("in range");
    assert_eq!(of(Sum::new(Sphere, Hyperbolic), x, radius), sum);
    let product = Product::<_, _, 2, 2>::new(Sphere, Hyperbolic);
    let beside = sphere.beside(of(Hyperbolic, [-0.4, 0.2], radius));
    assert_eq!(of(product, [0.3, 0.1, -0.4, 0.2], radius), beside);
    let flat = Constant::new(SMatrix::identity() * 2.0).expect("positive definite");
    let sum = sphere.plus(of(flat, x, radius)).expect("in range");
    assert!(sum.is_local() && of(Sum::new(Sphere, flat), x, radius) == sum);
    // A similarity by the factor 2 uses the ball of twice the radius about the image of the centre.
    let turn = SMatrix::<f64, 2, 2>::from([[1.2, 1.6], [-1.6, 1.2]]);
    let pulled = AffinePullback::new(Sphere, turn, vector![0.1, -0.2]).expect("regular");
    let image = turn * SVector::from(x) + vector![0.1, -0.2];
    let expected = of(Sphere, image.into(), 2.0 * radius).pulled_back(2.0, 2.0).expect("in range");
    let found = of(pulled, x, radius);
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b;
    assert!(close(found.c1(), expected.c1()) && close(found.c2(), expected.c2()), "{found:?}");
    assert!(close(found.l_h(), expected.l_h()) && found.is_local());
    assert!(close(found.m_h().expect("known"), expected.m_h().expect("known")), "{found:?}");
    // A reference to a metric has the constants of the metric.
    assert_eq!(of::<&Sphere, 2>(&Sphere, x, radius), sphere);
}

/// The patch has constants everywhere, and the underlying metric has better ones on a small ball.
#[test]
fn constants_of_a_ball_are_better_than_those_of_the_plane() {
    let patch = tautline_metrics::gallery::SpherePatch::new(2.0).expect("a radius");
    let everywhere = Bounded::<2>::constants(&patch);
    let nearby = Sphere.constants_within(&vector![0.0, 0.0], 0.1).expect("inside");
    assert!(nearby.c1() > 10.0 * everywhere.c1() && nearby.l_h() < everywhere.l_h());
}
