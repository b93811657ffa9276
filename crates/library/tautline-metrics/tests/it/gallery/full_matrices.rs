//! Metrics with full matrices: their formulas, and the places where their constants are attained.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, vector};
use tautline_metrics::{
    Bounded, Metric,
    gallery::{
        CoupledCosines, Link, RotatingAnisotropy, SineProjection, SineProjections, TwoLinkArm,
    },
    norm_squared,
};

use crate::measure::{curvature, directions, extremes, high, low, scan, slope};

#[test]
fn rotating_anisotropy_is_exact_everywhere() {
    for eigenvalues in [[1.0, 4.0], [3.0, 0.2]] {
        let k = vector![0.7, -1.1];
        let g = RotatingAnisotropy::new(eigenvalues, k).expect("positive");
        let x = vector![0.3, 0.9];
        low(&g, x);
        high(&g, x);
        slope(&g, x, k);
        curvature(&g, x, k);
        // λ₁ belongs to the direction (cos θ, sin θ).
        let (sin, cos) = k.dot(&x).sin_cos();
        let direction = vector![cos, sin];
        let image: SVector<f64, 2> = g.gram(&x) * direction;
        assert!((image - direction * eigenvalues[0]).norm() < 1e-14);
    }
}

#[test]
fn two_link_arm_is_exact() {
    for b in [0.8, -1.5] {
        let g = TwoLinkArm::new(4.0, b, 1.0).expect("3 > B²");
        let stretched = if b > 0.0 { 0.0 } else { PI };
        low(&g, vector![0.4, stretched]);
        high(&g, vector![0.4, stretched]);
        slope(&g, vector![0.4, FRAC_PI_2], vector![0.0, 1.0]);
        curvature(&g, vector![0.4, 0.0], vector![0.0, 1.0]);
    }
}

/// `H` gives twice the kinetic energy computed from the velocities of the two centres of mass.
#[test]
fn two_link_arm_has_the_kinetic_energy_of_its_links() {
    let upper = Link { mass: 2.0, length: 1.5, centre: 0.6, inertia: 0.3 };
    let lower = Link { mass: 0.7, length: 1.0, centre: 0.4, inertia: 0.1 };
    let g = TwoLinkArm::from_links(upper, lower).expect("positive masses");
    let (q, v) = (vector![0.3, 1.1], vector![-0.8, 2.0_f64]);
    let (turn, total) = (v[0], v[0] + v[1]);
    let elbow = upper.length * turn;
    // The velocity of the elbow and the velocity of the second centre relative to it enclose the
    // angle q₂.
    let swing = lower.centre * total;
    let speed2 = elbow * elbow + swing * swing + 2.0 * elbow * swing * f64::cos(q[1]);
    let twice = upper.inertia * turn * turn
        + upper.mass * (upper.centre * turn).powi(2)
        + lower.inertia * total * total
        + lower.mass * speed2;
    assert_relative_eq!(norm_squared(&g, &q, &v), twice, max_relative = 1e-14);
}

#[test]
fn coupled_cosines_are_exact_but_for_m_h() {
    let g = CoupledCosines;
    let zero = vector![0.0, 0.0, 0.0];
    low(&g, zero);
    high(&g, zero);
    assert!((1.326..1.327).contains(&g.constants().c1()), "{:?}", g.constants());
    assert!((2.504..2.505).contains(&g.constants().c2()), "{:?}", g.constants());
    slope(&g, vector![FRAC_PI_2, 0.0, FRAC_PI_2], vector![1.0, -2.0, 1.0]);
    // The norm of D²H[w, w] is largest at x = 0, and a scan over w in steps of 9° finds 0.72 of the
    // bound M_H.
    let places = (0..800).map(|i| {
        let (turn, tilt) = (f64::from(i % 40) * PI / 20.0, f64::from(i / 40) * PI / 20.0);
        (zero, vector![turn.cos() * tilt.sin(), turn.sin() * tilt.sin(), tilt.cos()])
    });
    let [_, ratio] = scan(&g, places);
    assert!((0.72..0.73).contains(&ratio), "{ratio}");
}

/// Evaluates the formulas in the documentation, with indices from 1 and without using symmetry.
#[test]
fn coupled_cosines_and_the_benchmark_are_their_formulas() {
    let x = vector![0.3, -0.8, 1.9];
    let h: SMatrix<f64, 3, 3> = CoupledCosines.gram(&x);
    for (i, j) in (0..3_usize).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let diagonal = if i == j { [1.0, 1.5, 2.0][i] } else { 0.0 };
        let entry = diagonal + 0.4 * f64::cos(x[i] - x[j]) / (1.0 + i.abs_diff(j) as f64);
        assert_relative_eq!(h[(i, j)], entry, max_relative = 1e-14);
    }
    let x = SVector::<f64, 8>::from_fn(|i, _| 0.1 * i as f64 - 0.2);
    let h = SineProjections::benchmark().gram(&x);
    let a = |k: usize, i: usize| 0.5 * (1.3 * (k * i) as f64).cos();
    let phase = |k: usize| (1..=8).map(|i| (0.7 * k as f64 + i as f64).sin() * x[i - 1]).sum();
    for (i, j) in (1..=8).flat_map(|i| (1..=8).map(move |j| (i, j))) {
        let term = |k: usize| 0.5 * f64::sin(phase(k)).powi(2) * a(k, i) * a(k, j);
        let entry = f64::from(i == j) + (1..=8).map(term).sum::<f64>();
        // The absolute tolerance covers the roundings of terms below 1/8 where they cancel.
        assert_relative_eq!(h[(i - 1, j - 1)], entry, epsilon = 1e-15, max_relative = 1e-14);
    }
}

#[test]
fn one_sine_projection_is_exact() {
    let (wave_vector, direction) = (vector![0.3, -0.4, 1.2], vector![2.0, 1.0, 0.5]);
    let g = SineProjections::new(vec![SineProjection { wave_vector, direction }]).expect("finite");
    // Returns the x with the phase w·x = θ.
    let at = |phase: f64| wave_vector * (phase / wave_vector.norm_squared());
    low(&g, at(0.3));
    high(&g, at(FRAC_PI_2));
    slope(&g, at(0.25 * PI), wave_vector);
    curvature(&g, at(0.0), wave_vector);
}

/// There is no point at which all terms of the benchmark are extreme, so a scan over the plane of
/// its wave vectors measures the overestimation.
#[test]
fn many_sine_projections_are_near_their_bounds() {
    let g = SineProjections::benchmark();
    let cosines = SVector::<f64, 8>::from_fn(|i, _| ((i + 1) as f64).cos());
    let sines = SVector::<f64, 8>::from_fn(|i, _| ((i + 1) as f64).sin());
    let grid = (0..1600)
        .map(|i| cosines * (f64::from(i % 40) * 0.04) + sines * (f64::from(i / 40) * 0.04));
    let highest = grid.clone().map(|x| extremes(&g.gram(&x)).1).fold(0.0, f64::max);
    let span = directions(8).map(|w| (cosines * w[0] + sines * w[1]).normalize());
    let [slope, curvature] = scan(&g, grid.flat_map(|x| span.clone().map(move |w| (x, w))));
    for (ratio, least) in [(highest / g.constants().c2(), 0.97), (slope, 0.79), (curvature, 0.68)] {
        assert!((least..1.0).contains(&ratio), "{ratio}");
    }
}
