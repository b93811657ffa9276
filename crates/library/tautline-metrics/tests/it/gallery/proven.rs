//! The inequalities behind constants without a closed form, proved by bisection in interval
//! arithmetic. The names agree with those in the derivations in `swirl.rs` and `two_channels.rs`.

use std::f64::consts::PI;

use nalgebra::{SMatrix, vector};
use tautline_metrics::{Scalar, gallery::Swirl};
use tautline_scalar::FastInterval;

use crate::measure::{first, second};

fn interval(low: f64, high: f64) -> FastInterval {
    FastInterval::new(low, high).expect("in order")
}

/// Returns whether `f ≤ bound` on the whole box. It bisects the longest side until the interval of
/// `f` on each part is below the bound, and returns `false` if a part of side 1e-3 is not.
fn below<const K: usize>(
    whole: [FastInterval; K],
    bound: f64,
    f: impl Fn([FastInterval; K]) -> FastInterval,
) -> bool {
    let mut parts = vec![whole];
    while let Some(part) = parts.pop() {
        if f(part).hi() <= bound {
            continue;
        }
        // The forms vary most in the first coordinate, y; weighting it halves the number of parts.
        let side = |i: usize| part[i].width() * if i == 0 { 2.5 } else { 1.0 };
        let longest = (0..K).fold(0, |best, i| if side(i) > side(best) { i } else { best });
        if side(longest) < 1e-3 {
            return false;
        }
        let (low, high) = (part[longest].lo(), part[longest].hi());
        let middle = 0.5 * (low + high);
        for half in [interval(low, middle), interval(middle, high)] {
            let mut halved = part;
            halved[longest] = half;
            parts.push(halved);
        }
    }
    true
}

/// `x (1 − x) ≤ 1/4` is proved, and no smaller bound.
#[test]
fn bisection_proves_what_is_true() {
    let f = |[x]: [FastInterval; 1]| x * (-x + 1.0);
    assert!(below([interval(0.0, 1.0)], 0.26, f));
    assert!(!below([interval(0.0, 1.0)], 0.249, f));
}

/// Returns the ranges of `y`, `χ` and `ω` with `w = e^{iω}`. Neither `(w, z) ↦ (−w, z)` nor the
/// reflection `(χ, ω) ↦ −(χ, ω)` changes the sums of squares, so half-turns of both angles are
/// enough.
fn frame() -> [FastInterval; 3] {
    [interval(0.0, 12.0), interval(0.0, PI), interval(0.0, PI)]
}

/// Returns `G₁²` and `G₂²`.
fn slopes<S: Scalar>([y, chi, omega]: [S; 3]) -> [S; 2] {
    let (c, s) = (omega.cos(), omega.sin());
    let rest = -y + 2.0;
    let g1 = rest * c * chi.sin() - s * chi.cos() * 2.0;
    let g2 = rest * c * (chi.cos() + 1.0) + s * chi.sin();
    let e = (-y).exp();
    [y * e * g1.sqr(), y * y.sqr() * e.sqr() * g2.sqr()]
}

/// Returns `F₁²` and `F₂²`.
fn curvatures<S: Scalar>([y, chi, omega]: [S; 3]) -> [S; 2] {
    let (c, s) = (omega.cos(), omega.sin());
    let (half_c, half_s) = ((chi * 0.5).cos(), (chi * 0.5).sin());
    let f1 = (omega * 2.0 - chi).sin() * 2.0
        - y * c * (omega - chi).sin() * 4.0
        - y * (y * c.sqr() - 1.0) * chi.sin();
    let radial = c.sqr() * (y * 4.0 - 16.0) * y + c.sqr() * 10.0 + (y * -2.0 + 2.0);
    let f2 =
        radial * half_c.sqr() + c * s * (y * -4.0 + 6.0) * chi.sin() + s.sqr() * half_s.sqr() * 2.0;
    let e = (-y).exp();
    [e * f1.sqr(), (y * e * f2).sqr()]
}

/// The forms agree with the odd and even parts in the angle of the metric's derivatives.
#[test]
fn the_forms_are_those_of_the_swirl() {
    let angle = 0.7;
    let [g, mirrored] = [angle, -angle].map(|angle| Swirl::new(angle, 1.0).expect("s > 0"));
    for step in 0..100 {
        let at = f64::from(step);
        // Incommensurable steps place frames all over the box.
        let [y, chi, omega] = [(0.618 * at) % 6.0, (1.414 * at) % PI, (1.732 * at) % PI];
        let x = vector![y.sqrt(), 0.0];
        let (w, z) =
            (vector![omega.cos(), omega.sin()], vector![(0.5 * chi).cos(), (0.5 * chi).sin()]);
        let parts = |plus: SMatrix<f64, 2, 2>, minus: SMatrix<f64, 2, 2>| {
            let [plus, minus] = [plus, minus].map(|derivative| z.dot(&(derivative * z)));
            [0.5 * (plus - minus) / angle, 0.5 * (plus + minus) / angle.powi(2)]
        };
        let first = parts(first(&g, &x, &w), first(&mirrored, &x, &w));
        let second = parts(second(&g, &x, &w), second(&mirrored, &x, &w));
        let squares = slopes([y, chi, omega]).into_iter().chain(curvatures([y, chi, omega]));
        for (part, square) in first.into_iter().chain(second).zip(squares) {
            // The squares are at most 5 and come from sums with about twenty roundings.
            assert!((part * part - square).abs() < 1e-13, "{part} {square} at {step}");
        }
    }
}

/// Proves `G₁²/λ² + G₂²/κ² ≤ 1.01²`.
#[test]
fn swirl_l_h_is_proven() {
    let lambda = 2.0 * (-0.5_f64).exp();
    let y = 0.25 * (9.0 - 33_f64.sqrt());
    let kappa = 2.0 * y.powf(1.5) * (2.0 - y) * (-y).exp();
    let squares = |part| {
        let [linear, quadratic] = slopes(part);
        linear * lambda.powi(-2) + quadratic * kappa.powi(-2)
    };
    assert!(below(frame(), 1.01_f64.powi(2), squares));
    assert!(!below(frame(), 1.004_f64.powi(2), squares), "the bound is almost sharp");
}

/// Proves `F₁²/4 + F₂²/(9/4)² ≤ 1.02²`.
#[test]
fn swirl_m_h_is_proven() {
    let squares = |part| {
        let [linear, quadratic] = curvatures(part);
        linear * 0.25 + quadratic * 2.25_f64.powi(-2)
    };
    assert!(below(frame(), 1.02_f64.powi(2), squares));
    assert!(!below(frame(), 1.01_f64.powi(2), squares), "the bound is almost sharp");
}

/// `uU (1 − V) + vV (1 − U) ≤ 2/3` for `u, v ≥ 0`. The expression is symmetric, and for `u ≥ 6` it
/// is at most `6e^{−18} + e^{−1/2}`.
#[test]
fn two_channels_l_h_is_proven() {
    let gaussian = |u: FastInterval| (u.sqr() * -0.5).exp();
    let slope = |[u, v]: [FastInterval; 2]| {
        let (near, far) = (gaussian(u), gaussian(v));
        u * near * (-far + 1.0) + v * far * (-near + 1.0)
    };
    let quarter = [interval(0.0, 6.0); 2];
    assert!(below(quarter, 2.0 / 3.0, slope));
    assert!(!below(quarter, 0.659, slope), "the bound is almost sharp");
}
