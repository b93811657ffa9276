//! Metrics with constants on balls only: the constants hold and are attained.

use std::f64::consts::SQRT_2;

use nalgebra::{SVector, vector};
use proptest::prelude::*;
use tautline_metrics::{
    HypothesisError, KnownDistance, LocalError, LocallyBounded,
    gallery::{GaussianFisher, Hyperbolic, Sphere},
};

use crate::{
    about::{About, in_ball},
    laws::{constants_hold, cube},
    measure::{curvature, high, low, slope},
};

/// Returns the sphere on a ball with the given centre and radius.
fn sphere<const D: usize>((centre, radius): (SVector<f64, D>, f64)) -> (About<Sphere, D>, f64) {
    (About::new(Sphere, centre * 2.0, radius), in_ball::<D>(radius))
}

/// Returns hyperbolic space on a ball, given by its centre and a fraction of the distance to the
/// rim.
fn hyperbolic<const D: usize>(
    (centre, share): (SVector<f64, D>, f64),
) -> (About<Hyperbolic, D>, f64) {
    let centre = centre * in_ball::<D>(1.8);
    let radius = share * (1.0 - centre.norm());
    (About::new(Hyperbolic, centre, radius), in_ball::<D>(radius))
}

constants_hold! {
    constants_of_the_sphere_hold_on_intervals, 1, seed 101: (cube(), 0.01..2.0_f64), sphere;
    constants_of_the_sphere_hold_on_discs, 2, seed 102: (cube(), 0.01..2.0_f64), sphere;
    constants_of_the_sphere_hold_on_balls, 3, seed 103: (cube(), 0.01..2.0_f64), sphere;
    constants_of_hyperbolic_space_hold_on_intervals, 1, seed 104:
        (cube(), 0.05..0.95_f64), hyperbolic;
    constants_of_hyperbolic_space_hold_on_discs, 2, seed 105: (cube(), 0.05..0.95_f64), hyperbolic;
    constants_of_hyperbolic_space_hold_on_balls, 3, seed 106: (cube(), 0.05..0.95_f64), hyperbolic;
    constants_of_gaussian_fisher_hold_on_discs, 2, seed 107: (cube::<2>(), 0.01..2.0_f64),
        |(centre, radius)| {
            (About::new(GaussianFisher, centre * 3.0, radius), in_ball::<2>(radius))
        };
}

/// The balls contain the origin, lie next to it, or lie beyond all extremes.
#[test]
fn constants_of_the_sphere_are_attained() {
    let ray = vector![0.6, 0.8];
    let across = vector![-0.8, 0.6];
    let [steepest, most] = [0.2_f64, 0.6].map(f64::sqrt);
    for (away, radius) in [(0.0, 0.3), (0.0, 2.0), (0.5, 0.2), (0.6, 0.5), (2.0, 0.5), (1.2, 0.1)] {
        let g = About::new(Sphere, ray * away, radius);
        let (near, far) = ((away - radius).max(0.0), away + radius);
        let at = |r: f64| ray * (r - away);
        low(&g, at(far));
        high(&g, at(near));
        slope(&g, at(steepest.max(near).min(far)), ray);
        // The maximum is attained across the ray or along it.
        let bent = most.max(near).min(far);
        let bend = |s: f64| (5.0 * s - 1.0) / (1.0 + s).powi(4);
        let along = bend(bent * bent) > 1.0 / (1.0 + near * near).powi(3);
        assert_eq!(along, away - radius > 0.5);
        if along { curvature(&g, at(bent), ray) } else { curvature(&g, at(near), across) }
    }
}

#[test]
fn constants_of_hyperbolic_space_are_attained() {
    let ray = vector![0.6, 0.8];
    for (away, radius) in [(0.0, 0.3), (0.5, 0.2), (0.3, 0.5), (0.9, 0.09)] {
        let g = About::new(Hyperbolic, ray * away, radius);
        let at = |r: f64| ray * (r - away);
        low(&g, at((away - radius).max(0.0)));
        high(&g, at(away + radius));
        slope(&g, at(away + radius), ray);
        curvature(&g, at(away + radius), ray);
    }
}

/// On the balls `e^{−2t}` is below 2, above it, or both.
#[test]
fn constants_of_gaussian_fisher_are_attained() {
    let up = vector![0.0, 1.0];
    for (t, radius) in [(3.0, 1.0), (-3.0, 1.0), (-0.3, 1.0)] {
        let g = About::new(GaussianFisher, vector![7.0, t], radius);
        low(&g, up * radius);
        high(&g, up * -radius);
        slope(&g, up * -radius, up);
        curvature(&g, up * -radius, up);
    }
}

#[test]
fn balls_without_constants_are_refused() {
    let origin = vector![0.0, 0.0];
    let everywhere = [
        Sphere.constants_within(&origin, f64::INFINITY),
        GaussianFisher.constants_within(&origin, f64::INFINITY),
    ];
    for outcome in everywhere {
        assert_eq!(outcome, Err(HypothesisError::NotCoercive { c1: 0.0 }.into()));
    }
    let outside = Hyperbolic.constants_within(&vector![0.5, 0.0], 0.5);
    let expected = LocalError::LeavesTheDomain { radius: 0.5, reach: 1.0, limit: 1.0 };
    assert_eq!(outside, Err(expected));
    assert!(Hyperbolic.constants_within(&origin, f64::INFINITY).is_err());
    for radius in [-1.0, f64::NAN] {
        let refused = [
            Sphere.constants_within(&origin, radius),
            Hyperbolic.constants_within(&origin, radius),
            GaussianFisher.constants_within(&origin, radius),
        ];
        for outcome in refused {
            assert!(matches!(outcome, Err(LocalError::NotARadius { .. })), "{outcome:?}");
        }
    }
    for nan in [vector![f64::NAN, 0.0], vector![0.0, f64::NAN]] {
        assert!(Sphere.constants_within(&nan, 1.0).is_err());
        assert!(Hyperbolic.constants_within(&nan, 0.1).is_err());
        assert!(GaussianFisher.constants_within(&nan, 1.0).is_err());
    }
}

proptest! {
    #![proptest_config(tautline_chance::config(108, 256))]

    /// The distance is `√2` times that of the half-plane, `arcosh(1 + |Δz|²/2σσ′)`, in any unit of
    /// the data.
    #[test]
    fn gaussian_fisher_knows_all_pairs(x in cube::<2>(), y in cube::<2>(), shift in -5.0..5.0_f64) {
        let (x, y) = (x * 3.0, y * 3.0);
        let d = GaussianFisher.distance(&x, &y).expect("always");
        let (s, t) = (x[1].exp(), y[1].exp());
        let cosh = 1.0 + (0.5 * (x[0] - y[0]).powi(2) + (s - t).powi(2)) / (2.0 * s * t);
        // Near 1, arcosh keeps half of the digits.
        prop_assert!((SQRT_2 * cosh.acosh() - d).abs() <= 1e-7);
        prop_assert_eq!(GaussianFisher.distance(&y, &x), Some(d));
        let scaled = |x: SVector<f64, 2>| vector![x[0] * shift.exp(), x[1] + shift];
        let other = GaussianFisher.distance(&scaled(x), &scaled(y)).expect("always");
        // Means up to e⁵ · 3 and logarithms up to 8 are rounded, and e^{−mean t} magnifies the
        // error.
        prop_assert!((other - d).abs() <= 1e-12 * (1.0 + d), "{other} {d}");
    }
}
