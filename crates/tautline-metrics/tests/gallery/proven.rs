//! The inequalities behind constants that have no closed form, proven by bisection in interval
//! arithmetic. Their names are those of the derivations in `swirl.rs` and `two_channels.rs`.

use std::f64::consts::PI;

use crate::interval::{Interval, below};

/// `y`, `χ` and `ω` with `w = e^{iω}`. Neither `(w, z) ↦ (−w, z)` nor the reflection
/// `(χ, ω) ↦ −(χ, ω)` changes the sums of squares: half-turns of both angles are enough.
fn frame() -> [Interval; 3] {
    [Interval::new(0.0, 12.0), Interval::new(0.0, PI), Interval::new(0.0, PI)]
}

/// `G₁²/λ² + G₂²/κ² ≤ 1.01²`.
#[test]
fn swirl_l_h_is_proven() {
    let lambda = 2.0 * (-0.5_f64).exp();
    let y = 0.25 * (9.0 - 33_f64.sqrt());
    let kappa = 2.0 * y.powf(1.5) * (2.0 - y) * (-y).exp();
    let squares = |[y, chi, omega]: [Interval; 3]| {
        let (c, s) = (omega.cos(), omega.sin());
        let rest = y * -1.0 + 2.0;
        let g1 = y * (y * -1.0).exp() * (rest * c * chi.sin() - s * chi.cos() * 2.0).sqr();
        let g2 = y * y.sqr() * (y * -2.0).exp();
        let g2 = g2 * (rest * c * (chi.cos() + 1.0) + s * chi.sin()).sqr();
        g1 * lambda.powi(-2) + g2 * kappa.powi(-2)
    };
    assert!(below(frame(), 1.01_f64.powi(2), squares));
    assert!(!below(frame(), 1.004_f64.powi(2), squares), "it is almost sharp");
}

/// `F₁²/4 + F₂²/(9/4)² ≤ 1.02²`.
#[test]
fn swirl_m_h_is_proven() {
    let squares = |[y, chi, omega]: [Interval; 3]| {
        let (c, s) = (omega.cos(), omega.sin());
        let (half_c, half_s) = ((chi * 0.5).cos(), (chi * 0.5).sin());
        let f1 = (omega * 2.0 - chi).sin() * 2.0
            - y * c * (omega - chi).sin() * 4.0
            - y * (y * c.sqr() + -1.0) * chi.sin();
        let radial = c.sqr() * (y * 4.0 + -16.0) * y + c.sqr() * 10.0 + (y * -2.0 + 2.0);
        let f2 = radial * half_c.sqr()
            + c * s * (y * -4.0 + 6.0) * chi.sin()
            + s.sqr() * half_s.sqr() * 2.0;
        let f1 = (y * -1.0).exp() * f1.sqr();
        let f2 = (y * (y * -1.0).exp() * f2).sqr();
        f1 * 0.25 + f2 * 2.25_f64.powi(-2)
    };
    assert!(below(frame(), 1.02_f64.powi(2), squares));
}

/// `uU (1 − V) + vV (1 − U) ≤ 2/3` for `u, v ≥ 0`; it is symmetric, and for `u ≥ 6` at most
/// `6e^{−18} + e^{−1/2}`.
#[test]
fn two_channels_l_h_is_proven() {
    let gaussian = |u: Interval| (u.sqr() * -0.5).exp();
    let slope = |[u, v]: [Interval; 2]| {
        let one = Interval::point(1.0);
        let (near, far) = (gaussian(u), gaussian(v));
        u * near * (one - far) + v * far * (one - near)
    };
    let quarter = [Interval::new(0.0, 6.0); 2];
    assert!(below(quarter, 2.0 / 3.0, slope));
    assert!(!below(quarter, 0.659, slope), "it is almost sharp");
}
