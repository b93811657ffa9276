//! Patches: metrics without constants, saturated outside of a ball or a strip. Their constants
//! hold and are attained; inside they are the metric that they are a patch of.
//!
//! What a bound gives away is a scan's ratio to it, in steps of a 4000th of the patch.

use nalgebra::{SMatrix, SVector, vector};
use tautline_metrics::{
    Bounded, Metric,
    gallery::{
        GalleryError, GaussianFisherPatch, Hyperbolic, HyperbolicPatch, Sphere, SpherePatch,
    },
};

use super::attained::{curvature, high, low, slope};
use crate::{
    laws::hold,
    measure::{first, norm, second},
};

pub(crate) fn sphere(radius: f64) -> SpherePatch {
    SpherePatch::new(radius).expect("a radius")
}

pub(crate) fn hyperbolic(radius: f64) -> HyperbolicPatch {
    HyperbolicPatch::new(radius).expect("a radius below √3/2")
}

pub(crate) fn fisher(rim: f64) -> GaussianFisherPatch {
    GaussianFisherPatch::new(rim).expect("a rim")
}

#[test]
fn constants_of_sphere_patch_hold() {
    hold::<1, _, _>(81, 0.05..3.0_f64, |radius| (sphere(radius), 2.0 * radius));
    hold::<2, _, _>(82, 0.05..3.0_f64, |radius| (sphere(radius), radius));
    hold::<3, _, _>(83, 0.9..3.0_f64, |radius| (sphere(radius), radius));
}

#[test]
fn constants_of_hyperbolic_patch_hold() {
    hold::<1, _, _>(84, 0.05..0.85_f64, |radius| (hyperbolic(radius), 2.0 * radius));
    hold::<2, _, _>(85, 0.05..0.85_f64, |radius| (hyperbolic(radius), radius));
    hold::<3, _, _>(86, 0.05..0.85_f64, |radius| (hyperbolic(radius), radius));
}

#[test]
fn constants_of_gaussian_fisher_hold() {
    hold(87, 0.05..4.0_f64, |rim| (fisher(rim), 1.5 * rim));
}

/// The largest measured slope and curvature along a line from `from` to `to`, in its direction and
/// across it, as parts of the constants.
fn scan(g: &impl Bounded<2>, from: SVector<f64, 2>, to: SVector<f64, 2>) -> (f64, f64) {
    let along = (to - from).normalize();
    let across = vector![-along[1], along[0]];
    let (mut steepest, mut most) = (0.0_f64, 0.0_f64);
    for i in 0..=10_000 {
        let x = from + (to - from) * (f64::from(i) / 10_000.0);
        steepest = steepest.max(norm(&first(g, &x, &along)));
        most = most.max(norm(&second(g, &x, &along))).max(norm(&second(g, &x, &across)));
    }
    let constants = g.constants();
    (steepest / constants.l_h(), most / constants.m_h().expect("known"))
}

/// The scan of a patch of the given radius: its centre, and the transition.
fn scan_ball(g: &impl Bounded<2>, radius: f64) -> (f64, f64) {
    let ray = vector![0.6, 0.8] * radius;
    let (steepest, most) = scan(g, ray * 0.8, ray * 1.3);
    (steepest, most.max(scan(g, ray * -0.5, ray * 0.5).1))
}

#[test]
fn sphere_patch_is_exact_if_it_is_large() {
    for radius in [0.448, 0.7, 1.0, 1.64, 1.73, 1.74, 5.0, 1e6] {
        let g = sphere(radius);
        low(&g, vector![3.0, 4.0] * radius);
        high(&g, vector![0.0, 0.0]);
        slope(&g, vector![0.6, -0.8] * 0.2_f64.sqrt(), vector![0.3, -0.4]);
        if radius >= 1.6 {
            curvature(&g, vector![0.0, 0.0], vector![1.0, 2.0]);
        }
    }
}

/// Measured: 0.9991 for the hyperbolic patch of radius 0.859, else at least 0.9995, and at most
/// 1 + 2e-16. A scan in steps of `R/20000` misses a maximum in the transition by some 1e-5; the
/// rest is what the bound is too large by.
const EXACT: std::ops::Range<f64> = 0.999..1.0 + 1e-12;

#[test]
fn sphere_patch_is_exact_if_it_is_small() {
    for radius in [1e-3, 0.2, 0.44, 0.45, 1.0, 1.5, 1.6] {
        let (steepest, most) = scan_ball(&sphere(radius), radius);
        // From R² = 1/5 on the steepest place is in the patch.
        assert!(EXACT.contains(&steepest) || radius > 0.447, "{radius}: {steepest}");
        assert!(EXACT.contains(&most), "{radius}: {most}");
    }
}

#[test]
fn hyperbolic_patch_is_exact() {
    for radius in [1e-3, 0.5, 0.8, 0.85, 0.859] {
        let g = hyperbolic(radius);
        low(&g, vector![0.0, 0.0]);
        high(&g, vector![-3.0, 4.0] * radius);
        let (steepest, most) = scan_ball(&g, radius);
        assert!(EXACT.contains(&steepest), "{radius}: {steepest}");
        assert!(EXACT.contains(&most), "{radius}: {most}");
    }
}

#[test]
fn gaussian_fisher_is_exact() {
    for rim in [1e-3, 0.1, 1.0, 3.0, 10.0, 100.0] {
        let g = fisher(rim);
        low(&g, vector![0.0, 4.0 * rim]);
        high(&g, vector![5.0, -4.0 * rim]);
        let (steepest, most) = scan(&g, vector![0.0, -0.8 * rim], vector![0.0, -1.4 * rim]);
        assert!(EXACT.contains(&steepest), "{rim}: {steepest}");
        assert!(EXACT.contains(&most), "{rim}: {most}");
    }
}

/// Values to some ulp, first derivatives as well, second ones to 1e-12 of their size; for
/// directions along the ray and across.
fn agree(patch: &impl Metric<2>, whole: &impl Metric<2>, x: &SVector<f64, 2>, second_to: f64) {
    let off = |a: SMatrix<f64, 2, 2>, b: SMatrix<f64, 2, 2>, scale: f64| (a - b).amax() / scale;
    let h: SMatrix<f64, 2, 2> = whole.gram(x);
    // Measured: 9 ε at most, where 1 − |x|² magnifies it.
    assert!(off(patch.gram(x), h, h.amax()) < 12.0 * f64::EPSILON, "{x}");
    for w in [vector![1.0, 0.0], vector![0.0, 1.0], vector![0.6, 0.8]] {
        let (slope, bend) = (first(whole, x, &w), second(whole, x, &w));
        let scale = h.amax().max(slope.amax());
        assert!(off(first(patch, x, &w), slope, scale) < 40.0 * f64::EPSILON, "{x}");
        let scale = scale.max(bend.amax());
        assert!(off(second(patch, x, &w), bend, scale) < second_to, "{x}");
    }
}

#[test]
fn inside_the_patch_is_the_whole_metric() {
    for i in 0..=200 {
        let x = vector![0.6, 0.8] * (f64::from(i) / 200.0);
        for radius in [0.1, 0.5, 1.0, 3.0, 1000.0] {
            agree(&sphere(radius), &Sphere, &(x * radius), 1e-12);
        }
        for radius in [0.1, 0.5, 0.85] {
            agree(&hyperbolic(radius), &Hyperbolic, &(x * radius), 1e-12);
        }
    }
}

/// `diag(e^{−2t}, 2)` on the whole plane.
struct WholeFisher;

impl Metric<2> for WholeFisher {
    fn gram<S: tautline_metrics::Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let information = (x[1] * -2.0).exp();
        SMatrix::from_diagonal(&vector![information, S::constant(2.0)])
    }
}

#[test]
fn inside_the_strip_is_the_metric_of_fisher() {
    for i in -200..=200 {
        for rim in [0.1, 1.0, 2.0] {
            let x = vector![7.0, rim * f64::from(i) / 200.0];
            agree(&fisher(rim), &WholeFisher, &x, 1e-12 * (1.0 + 1.0 / rim));
        }
    }
}

/// Just beyond the transition they are not: a radius that is wrong by a fifth fails here or above.
#[test]
fn outside_the_patch_it_is_another_metric() {
    let x = vector![0.6, 0.8] * 1.2;
    let phi = |h: SMatrix<f64, 2, 2>| h[(0, 0)];
    assert!(phi(sphere(1.0).gram(&x)) > 1.05 * phi(Sphere.gram(&x)));
    assert!(phi(hyperbolic(0.5).gram(&(x * 0.5))) < 0.99 * phi(Hyperbolic.gram(&(x * 0.5))));
    let t = vector![0.0, 1.5];
    assert!(phi(fisher(1.0).gram(&t)) > 1.3 * phi(WholeFisher.gram(&t)));
    assert!(phi(fisher(1.0).gram(&-t)) < phi(WholeFisher.gram(&-t)) / 1.3);
}

#[test]
fn radii_must_be_in_their_range() {
    let refused = |error: GalleryError| match error {
        GalleryError::OutOfRange { name, value, low, high } => (name, value.to_bits(), low, high),
        other => panic!("{other}"),
    };
    let bad = [0.0, -1.0, 1e-60, 1e60, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for value in bad {
        let bits = value.to_bits();
        let error = SpherePatch::new(value).expect_err("out of range");
        assert_eq!(refused(error), ("radius", bits, 1e-50, 1e50));
        let error = HyperbolicPatch::new(value).expect_err("out of range");
        assert_eq!(refused(error), ("radius", bits, 1e-50, 0.86));
        let error = GaussianFisherPatch::new(value).expect_err("out of range");
        assert_eq!(refused(error), ("rim", bits, 1e-50, 260.0));
    }
    assert!(HyperbolicPatch::new(0.86).is_err() && HyperbolicPatch::new(0.859).is_ok());
    assert!(GaussianFisherPatch::new(260.0).is_err() && GaussianFisherPatch::new(259.0).is_ok());
    assert!(SpherePatch::new(1e-50).is_err() && SpherePatch::new(1e50).is_err());
    assert!(SpherePatch::new(1e-49).is_ok() && SpherePatch::new(1e49).is_ok());
    let message = HyperbolicPatch::new(1.5).expect_err("out of range").to_string();
    assert_eq!(message, "radius = 1.5 must lie strictly between 1e-50 and 0.86");
}
