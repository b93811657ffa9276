//! Metrics with a known distance on some lines: these lines are minimal, and elsewhere shorter ways
//! exist.

use std::{
    cell::Cell,
    f64::consts::{FRAC_PI_2, PI},
};

use approx::assert_relative_eq;
use nalgebra::{SVector, Vector2, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Checkerboard, EggCrate, TwoChannels},
    norm_squared,
    quadrature::integrate,
};

use super::distances::{chord, distance, is_bounded, is_distance, run};

/// Returns the length of the chord with the bulge `c₁ sin πt + c₂ sin 2πt + c₃ sin 3πt` across it.
fn bulging(g: &impl Metric<2>, x: &Vector2<f64>, y: &Vector2<f64>, coefficients: [f64; 3]) -> f64 {
    let v = y - x;
    let across = vector![-v[1], v[0]].normalize();
    let speed = |t: f64| {
        let (mut point, mut velocity) = (x + v * t, v);
        for (n, c) in coefficients.iter().enumerate() {
            let frequency = (n + 1) as f64 * PI;
            let (sin, cos) = (frequency * t).sin_cos();
            point += across * (c * sin);
            velocity += across * (c * frequency * cos);
        }
        norm_squared(g, &point, &velocity).sqrt()
    };
    // We integrate in pieces so that the nodes resolve every wave of the metric.
    (0..16)
        .map(|i| integrate(speed, f64::from(i) / 16.0, f64::from(i + 1) / 16.0, 1e-9).value)
        .sum()
}

fn bulges() -> impl Strategy<Value = [f64; 3]> {
    uniform(-2.0..2.0_f64)
}

#[test]
fn egg_crate_is_flat_on_its_zero_lines() {
    let cases = (-2.0..2.0_f64, 0.2..3.0_f64, uniform::<_, 3>(-4.0..4.0_f64), -2..3_i32, bulges());
    run(51, cases, |(a, k, t, n, coefficients)| {
        let g = EggCrate::new(a, k).expect("k > 0");
        let shift = 2.0 * PI * f64::from(n) / k;
        let lines = [t.map(|t| vector![t, shift - t]), t.map(|t| vector![shift + PI / k + t, t])];
        for points in lines {
            is_distance(&g, points)?;
            let [x, y, z] = points;
            prop_assert_eq!(distance(&g, &x, &y), (x - y).norm());
            let length = bulging(&g, &x, &z, coefficients);
            prop_assert!(distance(&g, &x, &z) <= length * (1.0 + 1e-9), "not {length}");
            prop_assert_eq!(g.distance(&x, &(y + vector![1e-6, 0.0])), None);
        }
        Ok(())
    });
}

/// The points lie in the squares of negative curvature. The phases are relative to the centres of
/// the squares, which are saddles.
#[test]
fn egg_crate_is_known_on_short_crests() {
    let cases = (
        (-2.0..2.0_f64, 0.2..3.0_f64),
        uniform::<_, 2>(-1.5..1.5_f64),
        uniform::<_, 2>(-2..3_i32),
        any::<bool>(),
        bulges(),
    );
    let known = Cell::new(0);
    run(52, cases, |((s, k), phases, [m, n], swap, coefficients)| {
        let g = EggCrate::new(s / k, k).expect("k > 0");
        // The square about (X, Y) = (m + ½, n + ½) π has sin X sin Y < 0 for odd m + n.
        let n = n + i32::from((m + n).rem_euclid(2) == 0);
        let [x, y] = phases.map(|phase| {
            let point = vector![(f64::from(m) + 0.5) * PI, (f64::from(n) + 0.5) * PI + phase] / k;
            if swap { point.yx() } else { point }
        });
        // The length, in phases, of the shortest way that meets the boundary of the square.
        let detour = PI.hypot(phases[0] - phases[1]).min(PI - (phases[0] + phases[1]).abs());
        let Some(d) = g.distance(&x, &y) else {
            let length = chord(&g, &x, &y) * k;
            prop_assert!(length > detour * (1.0 - 1e-12), "{length} <= {detour}");
            return Ok(());
        };
        known.set(known.get() + 1);
        prop_assert!(d * k < detour * (1.0 + 1e-12), "{d} is not certain");
        prop_assert_eq!(g.distance(&y, &x), Some(d));
        prop_assert!((d - chord(&g, &x, &y)).abs() <= 1e-12 * d);
        is_bounded(&g, &x, &y)?;
        let length = bulging(&g, &x, &y, coefficients.map(|c| c / k));
        prop_assert!(d <= length * (1.0 + 1e-9), "{d} > {length}");
        // The neighbouring squares have positive curvature.
        let shift = if swap { vector![0.0, PI / k] } else { vector![PI / k, 0.0] };
        prop_assert_eq!(g.distance(&(x + shift), &(y + shift)), None);
        Ok(())
    });
    assert!((100..250).contains(&known.get()), "{} pairs of 256 are known", known.get());
}

/// Over a steep peak the symmetry line is a geodesic, but a curve around the peak is shorter.
#[test]
fn egg_crate_is_not_known_over_a_peak() {
    let g = EggCrate::new(6.0, 1.0).expect("k > 0");
    let (x, side, y) = (vector![FRAC_PI_2, 0.1], vector![0.1, FRAC_PI_2], vector![FRAC_PI_2, PI]);
    assert_eq!(g.distance(&x, &y), None);
    let round = chord(&g, &x, &side) + chord(&g, &side, &y);
    assert!(round < 0.9 * chord(&g, &x, &y), "{round}");
    // The first pair goes from saddle to saddle over the peak. The second lies in a square, but is
    // too far apart for the criterion.
    assert_eq!(g.distance(&vector![FRAC_PI_2, -FRAC_PI_2], &vector![FRAC_PI_2, 1.5 * PI]), None);
    assert_eq!(g.distance(&vector![FRAC_PI_2, -3.0], &vector![FRAC_PI_2, -0.1]), None);
    assert!(g.distance(&vector![FRAC_PI_2, -1.7], &vector![FRAC_PI_2, -1.4]).is_some());
    assert_eq!(g.distance(&x, &x), Some(0.0));
    assert_eq!(g.distance(&x, &vector![f64::NAN, 0.0]), None);
}

#[test]
fn checkerboard_is_known_on_its_grid() {
    let cases = (0.0..5.0_f64, 0.1..2.0_f64, uniform::<_, 3>(-4.0..4.0_f64), -5..6_i32, bulges());
    run(53, cases, |(a, e, t, n, coefficients)| {
        let g = Checkerboard::new(a, e).expect("e > 0");
        for swap in [false, true] {
            let point = |t: f64| vector![f64::from(n) * e, t];
            let points = t.map(|t| if swap { point(t).yx() } else { point(t) });
            is_distance(&g, points)?;
            let [x, y, _] = points;
            prop_assert_eq!(distance(&g, &x, &y), (x - y).norm());
            let length = bulging(&g, &x, &y, coefficients);
            prop_assert!(distance(&g, &x, &y) <= length * (1.0 + 1e-9), "not {length}");
            prop_assert_eq!(g.distance(&x, &y.add_scalar(1e-6)), None);
            prop_assert_eq!(g.distance(&x.add_scalar(f64::NAN), &y), None);
        }
        Ok(())
    });
}

/// The lanes around an expensive cell are shorter than its diagonal.
#[test]
fn checkerboard_is_not_known_across_a_cell() {
    let g = Checkerboard::new(10.0, 1.0).expect("e > 0");
    let (x, corner, y) = (vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 1.0]);
    assert_eq!(g.distance(&x, &y), None);
    let lanes = distance(&g, &x, &corner) + distance(&g, &corner, &y);
    assert_eq!(lanes, 2.0);
    assert!(lanes < 0.8 * chord(&g, &x, &y));
}

/// Every pair straight across the channels is known, and so are other pairs if their minimal
/// geodesic does not turn back in `x₂`.
#[test]
fn two_channels_has_a_distance() {
    let parameters = (0.0..5.0_f64, 0.1..2.0_f64, 0.1..2.0_f64);
    let cases = (parameters, uniform::<_, 3>(uniform::<_, 2>(-3.0..3.0_f64)), bulges());
    let known = Cell::new(0);
    run(54, cases, |((a, b, s), points, coefficients)| {
        let g = TwoChannels::new(a, b, s).expect("positive");
        is_distance(&g, points.map(|[x1, x2]| vector![0.3, x1 + x2]))?;
        let [x, y, z] = points.map(SVector::from);
        if let (Some(xy), Some(yz), Some(xz)) =
            (g.distance(&x, &y), g.distance(&y, &z), g.distance(&x, &z))
        {
            known.set(known.get() + 1);
            prop_assert!(xz <= xy + yz + 1e-12 && xy <= xz + yz + 1e-12 && yz <= xy + xz + 1e-12);
        }
        let Some(d) = g.distance(&x, &y) else { return Ok(()) };
        is_bounded(&g, &x, &y)?;
        prop_assert_eq!(g.distance(&y, &x), Some(d));
        // The mirror image of a curve has the same length.
        let [x_mirrored, y_mirrored] = [x, y].map(|x| vector![x[0], -x[1]]);
        let mirrored = distance(&g, &x_mirrored, &y_mirrored);
        prop_assert!((mirrored - d).abs() <= 1e-12 * d, "{mirrored}");
        let length = bulging(&g, &x, &y, coefficients);
        prop_assert!(d <= length * (1.0 + 1e-9), "{d} > {length}");
        Ok(())
    });
    assert!(known.get() > 20, "{} triples of 256 are known", known.get());
}

/// Between the ends of the axis, the way through either channel is shorter than the way along the
/// ridge.
#[test]
fn two_channels_has_two_ways() {
    let g = TwoChannels::new(4.0, 1.0, 0.4).expect("positive");
    let (x, y) = (vector![-3.0, 0.0], vector![3.0, 0.0]);
    let ways = [-1.0, 1.0].map(|side| {
        let (enter, leave) = (vector![-2.0, side], vector![2.0, side]);
        let bottom = distance(&g, &enter, &leave);
        assert_eq!(bottom, 4.0);
        distance(&g, &x, &enter) + bottom + distance(&g, &leave, &y)
    });
    assert_relative_eq!(ways[0], ways[1], max_relative = 1e-14);
    assert!(ways[0] < 0.9 * chord(&g, &x, &y), "{}", ways[0]);
    // Both geodesics turn back in x₂, so Clairaut's relation proves nothing.
    assert_eq!(g.distance(&x, &y), None);
    assert_eq!(g.distance(&x, &vector![f64::NAN, 2.0]), None);
}

/// Far along a channel `d` exceeds `|x₁ − y₁| + ∫ √(n² − 1) dx₂`, the bound for `p = 1`. The
/// difference falls by the factor `e^{−√8}` per unit of length, since `n² − 1 = 8 (x₂ − 1)² + …`.
#[test]
fn two_channels_is_known_along_a_channel() {
    let g = TwoChannels::new(4.0, 1.0, 0.5).expect("positive");
    let n2 = |x2: f64| norm_squared(&g, &vector![0.0, x2], &vector![1.0, 0.0]);
    let root = |x2: f64| (n2(x2) - 1.0).max(0.0).sqrt();
    // The rounding error is 1e-16 in n² − 1, at most 1e-8 in the root, and 1e-16 in the integral.
    let [left, right] = [[0.5, 1.0], [1.0, 1.7]].map(|[a, b]| integrate(root, a, b, 1e-13).value);
    let excess =
        |way: f64| distance(&g, &vector![0.0, 0.5], &vector![way, 1.7]) - (way + left + right);
    let rate = (excess(2.0) / excess(4.0)).ln() / 2.0;
    assert!((rate - 8_f64.sqrt()).abs() < 0.05, "{rate}");
    assert!(excess(9.0).abs() < 1e-10, "{}", excess(9.0));
    assert_eq!(g.distance(&vector![0.0, 0.5], &vector![12.0, 1.7]), None);
}

/// A single quadrature over a length of 2e3 would miss channels of width 1e-3.
#[test]
fn two_channels_is_not_missed_by_the_quadrature() {
    let g = TwoChannels::new(3.0, 1.0, 1e-3).expect("positive");
    let d = distance(&g, &vector![0.0, -1e3], &vector![0.0, 1e3]);
    // √(1 + 3 (1 − e^{−ρ²/2})) is below 2 by the same amount in both channels.
    let missing = |rho: f64| 2.0 - (1.0 - 3.0 * (-0.5 * rho * rho).exp_m1()).sqrt();
    let lost = integrate(missing, 0.0, 12.0, 1e-15).value;
    assert_relative_eq!(d, 4e3 - 4e-3 * lost, max_relative = 1e-15);
    assert!(lost > 0.5);
}
