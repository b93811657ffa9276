//! Layered metrics `f² I`, where `f ≥ 1` is a function of one coordinate, and Clairaut's relation.

use crate::quadrature::{Integral, integrate};

/// If the relative error estimate of an integral exceeds this, the distance does not count as
/// known.
const TRUSTED: f64 = 1e-8;

/// Returns the distance between two points whose layered coordinates are `knots[0]` and
/// `knots[last]`, and which are `across ≥ 0` apart in the other coordinates. `excess` is `f² − 1`,
/// computed without cancellation where it vanishes. The knots increase, and they are so close that
/// a quadrature between two neighbours misses no detail.
///
/// Let `s` be the coordinate along the difference in the other coordinates. For `0 ≤ p < 1` the
/// function `u = p s + ∫ √(f² − p²)` satisfies `|∇u| = f` everywhere. So `d ≥ u(y) − u(x)`, with
/// equality along the curve of steepest ascent. This curve joins the points if `∫ p / √(f² − p²)`
/// equals their difference in `s` (Clairaut's relation).
///
/// Returns `None` if no such `p` exists (up to `1 − 10⁻¹²`), because the minimal geodesic then
/// turns back in the layered coordinate. Also returns `None` if a quadrature does not converge
/// because there are too many layers between two knots.
pub(super) fn across_layers(
    excess: impl Fn(f64) -> f64,
    knots: &[f64],
    across: f64,
) -> Option<f64> {
    let sum = |f: &dyn Fn(f64) -> f64, tolerance: f64| -> Integral {
        let mut sum = Integral::default();
        for ends in knots.windows(2) {
            sum += integrate(f, ends[0], ends[1], tolerance);
        }
        sum
    };
    // We work with q = 1 − p, for which f² − p² = (f² − 1) + q (2 − q) does not cancel. The noise
    // due to cancellation would exhaust the intervals of the quadrature.
    let root = |x: f64, q: f64| (excess(x) + q * (2.0 - q)).sqrt();
    let reach_of = |q: f64| sum(&|x| (1.0 - q) / root(x, q), 1e-10);
    let reach = |q: f64| reach_of(q).value;
    let (mut high, mut low) = (1.0_f64, 1e-12_f64);
    if !(reach(low) >= across) {
        return None;
    }
    // u(y) − u(x) is stationary in p. The error in p, due to the bisection and the reach, is about
    // 1e-9 q. The derivative of the reach is at most of order q^{−3/2}, so the resulting error in
    // u(y) − u(x) is about 1e-18.
    if across > 0.0 {
        for _ in 0..35 {
            let middle = (low * high).sqrt();
            *(if reach(middle) < across { &mut high } else { &mut low }) = middle;
        }
    }
    let climb = sum(&|x| root(x, high), 1e-15);
    // Both are accurate to about 1e-10 unless the intervals were exhausted, and then p may be
    // wrong.
    let known = |found: Integral| found.error <= TRUSTED * found.value;
    (known(climb) && (across == 0.0 || known(reach_of(high))))
        .then_some((1.0 - high) * across + climb.value)
}
