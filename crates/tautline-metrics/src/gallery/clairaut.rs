//! Layers: metrics `f² I` with `f ≥ 1` a function of one coordinate, and Clairaut's relation.

use crate::quadrature::{Integral, integrate};

/// The largest relative error estimate of an integral that counts as known.
const TRUSTED: f64 = 1e-8;

/// Returns the distance of two points with the layered coordinates `knots[0]` and `knots[last]`, and
/// `across ≥ 0` apart in the others. `excess` is `f² − 1`, without cancellation where it vanishes.
/// The knots ascend, and between two of them one quadrature misses no detail.
///
/// For `0 ≤ p < 1` the function `u = p s + ∫ √(f² − p²)`, with `s` the coordinate along the
/// difference of the other coordinates, satisfies `|∇u| = f` everywhere. So `d ≥ u(y) − u(x)`,
/// with equality along the curve of steepest ascent, which joins the points if
/// `∫ p / √(f² − p²)` is their difference in `s` (Clairaut's relation).
///
/// `None` if no such `p` exists (up to `1 − 10⁻¹²`): the minimal geodesic then turns back in the
/// layered coordinate. `None` too if a quadrature does not converge, because there are too many
/// layers between two knots.
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
    // In q = 1 − p, where f² − p² = (f² − 1) + q (2 − q) does not cancel: noise would exhaust the
    // intervals of the quadrature.
    let root = |x: f64, q: f64| (excess(x) + q * (2.0 - q)).sqrt();
    let reach_of = |q: f64| sum(&|x| (1.0 - q) / root(x, q), 1e-10);
    let reach = |q: f64| reach_of(q).value;
    let (mut high, mut low) = (1.0_f64, 1e-12_f64);
    if !(reach(low) >= across) {
        return None;
    }
    // u(y) − u(x) is stationary in p. The error of p is some 1e-9 q, from the bisection and from
    // the reach, and the derivative of the reach is of the order of q^{−3/2} at most: that of
    // u(y) − u(x) is some 1e-18.
    if across > 0.0 {
        for _ in 0..35 {
            let middle = (low * high).sqrt();
            *(if reach(middle) < across { &mut high } else { &mut low }) = middle;
        }
    }
    let climb = sum(&|x| root(x, high), 1e-15);
    // Both are accurate to some 1e-10, unless the intervals were exhausted: then p may be wrong.
    let known = |found: Integral| found.error <= TRUSTED * found.value;
    (known(climb) && (across == 0.0 || known(reach_of(high))))
        .then_some((1.0 - high) * across + climb.value)
}
