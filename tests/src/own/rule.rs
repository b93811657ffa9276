//! A user's rule: Newton's rule of three eighths.

use tautline::{
    Ends, Interpolation, Node, PointSequence, Problem, Rule, SVector,
    gallery::{Shear, Valleys},
};

/// The weights are in the ratio 1 : 3 : 3 : 1, at the two ends of a chord and at its thirds.
const THREE_EIGHTHS: Rule = Rule::new(
    "three_eighths",
    &[
        Node { fraction: 0.0, weight: 1.0 / 8.0 },
        Node { fraction: 1.0 / 3.0, weight: 3.0 / 8.0 },
        Node { fraction: 2.0 / 3.0, weight: 3.0 / 8.0 },
        Node { fraction: 1.0, weight: 1.0 / 8.0 },
    ],
    2,
);

/// The rule integrates `uᵀHu` along a chord up to its fourth derivative. The discrete energy
/// therefore agrees with the energy of the interpolation to within `max |(f²)⁗| |d|⁴ / 6480`,
/// relative to `|β|²`.
#[test]
fn a_users_rule_integrates_what_its_nodes_say() {
    let points = [0.0, 0.4, 0.7, 1.1, 1.5, 1.9].map(|x: f64| SVector::from([x, x.sin()]));
    let sequence = PointSequence::new(points.to_vec()).expect("finite");
    let energy = Interpolation::new(&sequence).energy(&Valleys).value;
    let gap = (THREE_EIGHTHS.energy(&Valleys, &sequence) - energy).abs();
    // f² = 4.5 − 4 cos x + ½ cos 2x satisfies |(f²)⁗| ≤ 4 + 8 = 12, and chords extend over at most
    // 0.4 in x₁.
    let bound = 12.0 * 0.4_f64.powi(4) / 6480.0 * sequence.k3().powi(2);
    assert!(gap <= bound, "{gap:e} exceeds {bound:e}");
    // f² is convex up to 1.94, so that the errors of the trapezoidal rule add up, and it would
    // violate this bound.
    let trapezoidal = tautline::Rule::TRAPEZOIDAL.energy(&Valleys, &sequence);
    assert!((trapezoidal - energy).abs() > 10.0 * bound);
}

/// `E_N` agrees with `E(γᵖˡ)` to within `N⁻⁴`, so its error is the smallest that an interpolation
/// can have: `N² (E_N − d²) → (1/12) ∫ γ̈ᵀHγ̈ = (27/16) (½ − sin 6/12)` from `(0, 0)` to `(2, 3)`.
#[test]
fn a_users_rule_is_minimised() {
    let d2 = (2.0 + 0.5 * 3_f64.sin()).powi(2) + 9.0;
    let ends = Ends::points([0.0, 0.0], [2.0, 3.0]).expect("finite");
    let problem = Problem::new(Shear::new(0.5, 1.0).expect("valid"), ends);
    let scaled = |n: usize| {
        let line = problem.solve(THREE_EIGHTHS, n).expect("a metric");
        assert!(line.minimum().is_local_minimum());
        (n * n) as f64 * (line.discrete_energy() - d2)
    };
    let limit = (4.0 * scaled(512) - scaled(256)) / 3.0;
    let expected = 27.0 / 16.0 * (0.5 - 6_f64.sin() / 12.0);
    // One extrapolation leaves a relative error of (10/256)⁴; rounding contributes 2^18 · 2e-15 ·
    // 13.
    assert!((limit - expected).abs() <= 1e-6, "{limit} is not {expected}");
    let estimate = problem.solve(THREE_EIGHTHS, 512).expect("a metric").distance_squared_estimate();
    let estimate = estimate.expect("several grids").value;
    // The grids 8, 32, 128 and 512 remove the terms up to N⁻⁶; the ulp of 13.3 is 2e-15.
    assert!((estimate - d2).abs() <= 1e-10, "{:e}", estimate - d2);
}
