//! Distances in patches: they are those of the whole metric if and only if its geodesic stays in
//! the patch.

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use approx::assert_relative_eq;
use nalgebra::{SVector, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Hyperbolic, Sphere},
    norm_squared,
    quadrature::integrate,
};

use super::{
    distances::{chord, distance, is_bounded, is_distance, run},
    patches::{fisher, hyperbolic, sphere},
};

/// Maps a point of the cube to the closed ball. The direction stays the same, and the largest
/// coordinate becomes the fraction of the radius.
fn in_ball<const D: usize>(x: [f64; D], radius: f64) -> SVector<f64, D> {
    let x = SVector::from(x);
    // The point is slightly inside, so that rounding does not move it beyond the rim.
    if x.norm() > 0.0 { x * (0.999_999 * radius * x.amax() / x.norm()) } else { x }
}

/// Returns the point and the velocity at `s` of the geodesic `(f(d − s) P + f(s) Q) / f(d)` of the
/// sphere or of the hyperboloid, projected to the plane, with `f = sin` or `sinh`. `e` is the sign
/// of the curvature.
fn geodesic(
    e: f64,
    [x, y]: [SVector<f64, 2>; 2],
    d: f64,
    s: f64,
) -> (SVector<f64, 2>, SVector<f64, 2>) {
    let lift = |x: SVector<f64, 2>| {
        let r2 = e * x.norm_squared();
        vector![2.0 * x[0], 2.0 * x[1], 1.0 - r2] / (1.0 + r2)
    };
    let f = |s: f64| if e > 0.0 { s.sin() } else { s.sinh() };
    let df = |s: f64| if e > 0.0 { s.cos() } else { s.cosh() };
    let point = (lift(x) * f(d - s) + lift(y) * f(s)) / f(d);
    let velocity = (lift(y) * df(s) - lift(x) * df(d - s)) / f(d);
    let scale = 1.0 / (1.0 + point[2]);
    let flat = vector![point[0], point[1]] * scale;
    (flat, (vector![velocity[0], velocity[1]] - flat * velocity[2]) * scale)
}

/// The distance equals the length, in the patch, of the geodesic of the whole metric.
fn is_attained(
    g: &impl Metric<2>,
    ends: [SVector<f64, 2>; 2],
    d: f64,
    e: f64,
) -> Result<(), TestCaseError> {
    let speed = |s: f64| {
        let (x, v) = geodesic(e, ends, d, s);
        norm_squared(g, &x, &v).sqrt()
    };
    let length = integrate(speed, 0.0, d, 1e-13).value;
    // Near antipodes f(d) cancels, so the cases stay 1e-3 away from them.
    prop_assert!((length - d).abs() <= 1e-11 * (1.0 + d), "{length} {d}");
    Ok(())
}

/// No curve is shorter, not even a detour over a point outside.
fn is_minimal(
    g: &(impl Metric<2> + KnownDistance<2>),
    [x, y, detour]: [SVector<f64, 2>; 3],
) -> Result<(), TestCaseError> {
    let d = distance(g, &x, &y);
    let around = chord(g, &x, &detour) + chord(g, &detour, &y);
    prop_assert!(d <= around * (1.0 + 1e-12), "{d} > {around}");
    Ok(())
}

/// All pairs of a patch are known and have the distance of the whole metric, of curvature `$e`.
macro_rules! all_pairs_are_known {
    ($($test:ident, seed $seed:literal: $patch:ident, $radii:expr, of $whole:ident, $e:literal,
       detours within $reach:literal;)*) => {$(
        #[test]
        fn $test() {
            let cases = ($radii, uniform::<_, 3>(uniform::<_, 2>(-1.0..1.0_f64)));
            run($seed, cases, |(radius, points)| {
                let g = $patch(radius);
                let detour = SVector::from(points[2]) * ($reach * radius);
                let points = points.map(|x| in_ball(x, radius));
                is_distance(&g, points)?;
                is_bounded(&g, &points[0], &points[1])?;
                let [x, y, _] = points;
                is_minimal(&g, [x, y, detour])?;
                let d = distance(&g, &x, &y);
                prop_assert_eq!(Some(d), $whole.distance(&x, &y));
                is_attained(&g, [x, y], d, $e)
            });
        }
    )*};
}

all_pairs_are_known! {
    sphere_patch_up_to_a_hemisphere_knows_all_pairs, seed 91:
        sphere, 0.05..1.0_f64, of Sphere, 1.0, detours within 3.0;
    hyperbolic_patch_knows_all_pairs, seed 93:
        hyperbolic, 0.05..0.85_f64, of Hyperbolic, -1.0, detours within 2.0;
}

/// The result is compared with the farthest of 2000 points of the arc, which is accurate to a
/// relative 1e-6. Antipodes are left out, and so are pairs with an arc that close to the rim.
#[test]
fn a_large_sphere_patch_knows_pairs_whose_arc_stays() {
    let cases = (1.0..5.0_f64, uniform::<_, 2>(uniform::<_, 2>(-1.0..1.0_f64)));
    let counts = std::cell::Cell::new((0, 0));
    run(92, cases, |(radius, points)| {
        let g = sphere(radius);
        let [x, y] = points.map(|x| in_ball(x, radius));
        let d = Sphere.distance(&x, &y).expect("always");
        prop_assume!(d < std::f64::consts::PI - 1e-3);
        let arc = (0..=2000).map(|i| geodesic(1.0, [x, y], d, d * f64::from(i) / 2000.0).0.norm());
        let farthest = arc.fold(0.0, f64::max);
        prop_assume!((farthest / radius - 1.0).abs() > 1e-5 || farthest <= x.norm().max(y.norm()));
        let stays = farthest <= radius;
        prop_assert_eq!(g.distance(&x, &y), stays.then_some(d));
        prop_assert_eq!(g.distance(&y, &x), stays.then_some(d));
        // If leaving the patch costs more than the arc, the arc stays in the patch.
        let to_rim = |x: &SVector<f64, 2>| 2.0 * (radius.atan() - x.norm().atan());
        prop_assert!(stays || d > to_rim(&x) + to_rim(&y));
        let (known, unknown) = counts.get();
        counts.set(if stays { (known + 1, unknown) } else { (known, unknown + 1) });
        if stays { is_attained(&g, [x, y], d, 1.0) } else { Ok(()) }
    });
    let (known, unknown) = counts.get();
    assert!(known > 30 && unknown > 30, "{known} {unknown}");
}

/// The geodesics are half-circles `(μ/√2, σ) = (c + ρ cos φ, ρ sin φ)`; the test takes two points
/// of one, and its top.
#[test]
fn gaussian_fisher_knows_pairs_whose_half_circle_stays() {
    let cases = (0.2..2.0_f64, -2.0..2.0_f64, 0.1..5.0_f64, uniform::<_, 2>(0.05..3.1_f64));
    let counts = std::cell::Cell::new((0, 0));
    run(94, cases, |(rim, centre, rho, angles)| {
        let g = fisher(rim);
        let at = |phi: f64| vector![SQRT_2 * (centre + rho * phi.cos()), (rho * phi.sin()).ln()];
        let [x, y] = angles.map(at);
        let (first, last) = (angles[0].min(angles[1]), angles[0].max(angles[1]));
        prop_assume!(last - first > 1e-3);
        let on_top = first < FRAC_PI_2 && last > FRAC_PI_2;
        let top = if on_top { rho.ln() } else { x[1].max(y[1]) };
        let bottom = x[1].min(y[1]);
        prop_assume!((top - rim).abs() > 1e-9 && (bottom + rim).abs() > 1e-9);
        let stays = top <= rim && bottom >= -rim;
        prop_assert_eq!(g.distance(&x, &y).is_some(), stays);
        let (known, unknown) = counts.get();
        counts.set(if stays { (known + 1, unknown) } else { (known, unknown + 1) });
        if !stays {
            return Ok(());
        }
        let d = distance(&g, &x, &y);
        prop_assert_eq!(d, distance(&g, &y, &x));
        is_bounded(&g, &x, &y)?;
        let speed = |phi: f64| {
            let v = vector![-SQRT_2 * rho * phi.sin(), phi.cos() / phi.sin()];
            norm_squared(&g, &at(phi), &v).sqrt()
        };
        let length = integrate(speed, first, last, 1e-13).value;
        prop_assert!((length - d).abs() <= 1e-11 * (1.0 + d), "{length} {d}");
        // This is the usual formula, which loses half of the digits for near points.
        let (s, t) = (x[1].exp(), y[1].exp());
        let cosh = 1.0 + (0.5 * (x[0] - y[0]).powi(2) + (s - t).powi(2)) / (2.0 * s * t);
        prop_assert!((SQRT_2 * cosh.acosh() - d).abs() <= 1e-10 * (1.0 + d), "{d}");
        Ok(())
    });
    let (known, unknown) = counts.get();
    assert!(known > 30 && unknown > 30, "{known} {unknown}");
}

/// No detour is shorter, not even through the cheap half of the plane or beyond the strip.
#[test]
fn gaussian_fisher_has_a_distance() {
    let cases = (0.2..2.0_f64, uniform::<_, 3>(uniform::<_, 2>(-1.0..1.0_f64)), -3.0..3.0_f64);
    run(95, cases, |(rim, points, detour)| {
        let g = fisher(rim);
        // The points are so close in μ that the half-circles hardly rise: a/2 ≤ 0.05 e^{−T}.
        let width = 0.05 * (-rim).exp();
        let [x, y, z] = points.map(|[mean, t]| vector![width * mean, 0.99 * rim * t]);
        is_distance(&g, [x, y, z])?;
        is_minimal(&g, [x, y, vector![z[0], detour * rim]])
    });
}

#[test]
fn the_top_of_a_half_circle_decides() {
    let g = fisher(1.0);
    // The half-circle stays in the strip if ρ² = m²/2 + 1 ≤ e².
    let m = (2.0 * (2_f64.exp() - 1.0)).sqrt();
    for (mean, stays) in [(0.999 * m, true), (1.001 * m, false)] {
        let d = g.distance(&vector![-mean, 0.0], &vector![mean, 0.0]);
        assert_eq!(d.is_some(), stays, "{mean}");
    }
    // The arc rises all the way to the rim, so there is no top in between.
    assert!(g.distance(&vector![0.0, -1.0], &vector![1.0, 1.0]).is_some());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(g.distance(&vector![bad, 0.0], &vector![1.0, 0.0]), None);
        assert_eq!(g.distance(&vector![1.0, 0.0], &vector![1.0, bad]), None);
        assert_eq!(sphere(1.0).distance(&vector![0.0, 0.5], &vector![0.5, bad]), None);
        assert_eq!(sphere(1.0).distance(&vector![bad, 0.5], &vector![0.5, 0.0]), None);
        assert_eq!(hyperbolic(0.5).distance(&vector![bad, 0.0], &vector![0.1, 0.0]), None);
        assert_eq!(hyperbolic(0.5).distance(&vector![0.1, 0.0], &vector![0.0, bad]), None);
    }
    assert_eq!(g.distance(&vector![0.0, 1.01], &vector![0.0, 0.0]), None);
    assert_eq!(g.distance(&vector![0.0, 0.0], &vector![0.0, -1.01]), None);
    assert_eq!(sphere(1.0).distance(&vector![0.0], &vector![1.01]), None);
    assert_eq!(sphere(1.0).distance(&vector![1.01], &vector![0.0]), None);
    assert_eq!(hyperbolic(0.5).distance(&vector![0.51], &vector![0.0]), None);
    assert_eq!(hyperbolic(0.5).distance(&vector![0.0], &vector![0.51]), None);
}

/// The shorter arc passes over the south pole, outside the patch.
#[test]
fn a_sphere_patch_does_not_know_pairs_beyond_its_hole() {
    let g = sphere(3.0);
    assert_eq!(g.distance(&vector![2.9, 0.0], &vector![-2.9, 0.0]), None);
    assert_eq!(g.distance(&vector![2.9], &vector![-2.9]), None);
    let d = g.distance(&vector![2.9, 0.0], &vector![2.0, 0.0]).expect("one ray");
    assert_relative_eq!(d, 2.0 * (2.9_f64.atan() - 2_f64.atan()), max_relative = 1e-14);
    assert_eq!(g.distance(&vector![2.9, 0.0], &vector![2.9, 0.0]), Some(0.0));
}
