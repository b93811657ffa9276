//! Bounds of order `1/N`, sharper than the paper's `1/√N`, with neither `c₂` nor `D`.
//!
//! With `δ = L_H d / c₁^{3/2}` and `κ = c₂/c₁`, pure numbers, and `k = ¼` for the trapezoidal
//! rule, `k = ½` for the left-endpoint rule:
//!
//! 1. *From above.* A minimal geodesic `γ` has `|γ̇| ≤ d/√c₁ = A₁`, and the geodesic equation gives
//!    `|γ̈| ≤ (3 L_H / 2c₁) A₁² = A₂`. Sampled at `tₙ = n/N` it is admissible. Its differences `βₙ`
//!    are means of `γ̇` over subintervals, so by Jensen `βₙᵀ A βₙ ≤ N ∫ γ̇ᵀ A γ̇` for the matrix `A` that
//!    the rule reads; and that differs from `H(γ(t))` by `L_H` times a distance along the
//!    geodesic. Hence `min E_N ≤ d² e` with
//!
//!    ```text
//!    e = min(κ, 1 + δ/4N + δ²/8N²)  (trapezoidal),     e = min(κ, 1 + δ/2N)  (left endpoint)
//!    ```
//!
//!    where `κ` comes from equidistant points on the chord of a geodesic.
//! 2. *Equal speeds.* Where the inner points are stationary, the roots `qₙ` of `βₙᵀ H βₙ` obey
//!    `|qₙ − qₙ₋₁| ≤ (L_H / N c₁^{3/2}) (qₙ² + qₙ₋₁²)/2` up to the weights of the two, so that
//!    `max qₙ ≤ √E_N + (L_H/c₁^{3/2}) E_N`; and trivially `max qₙ ≤ √(N E_N)`.
//! 3. *The gap.* `|E(γᵖˡ) − E_N| ≤ (k L_H/N) mean |βₙ|³ ≤ (k L_H/N c₁^{3/2}) max qₙ · E_N`, which
//!    is `d² (k δ/N) e Q` with `Q = min(√(N e), √e + δ e)`.

use std::num::NonZeroUsize;

use crate::{Setting, product::product};

/// Bounds `min E_tra,N − d²`, in `m²`, by `d² (e − 1) = O(1/N)`.
///
/// ```text
/// min E_tra,N − d²  ≤  d² min(c₂/c₁ − 1, δ/4N + δ²/8N²),     δ = L_H d / c₁^{3/2}
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser. `c₂` and `D` are not needed but
/// for the first entry of the minimum.
///
/// Slack: the constant `δ/4` cannot be improved for all metrics with these constants; on one
/// smooth metric the gap is of order `1/N²`.
#[must_use]
pub fn first_order_minimum_gap_trapezoidal(setting: Setting, n: NonZeroUsize) -> f64 {
    product([setting.distance(), setting.distance(), above_one(setting, n, Rule::Trapezoidal)])
}

/// Bounds `min E_l,N − d²`, in `m²`, by `d² (e − 1) = O(1/N)`.
///
/// ```text
/// min E_l,N − d²  ≤  d² min(c₂/c₁ − 1, δ/2N),     δ = L_H d / c₁^{3/2}
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser. Slack: `δ/2` cannot be improved
/// for all metrics with these constants.
#[must_use]
pub fn first_order_minimum_gap_left(setting: Setting, n: NonZeroUsize) -> f64 {
    product([setting.distance(), setting.distance(), above_one(setting, n, Rule::Left)])
}

/// Bounds `E(γᵖˡ) − E_tra,N(γᵖ)`, and `d² − E_tra,N(γᵖ)`, in `m²`, by `d² (δ/4N) e Q = O(1/N)`.
///
/// Needs: the setting of Theorem 1.1, and a sequence that is stationary in its inner points with
/// `E_tra,N ≤ d² e`, as a *global* minimiser is. `e` and `Q` are those of the module's
/// derivation.
///
/// Slack: attained at `N = 1` by a tent; on one smooth metric the gap is of order `1/N²`.
#[must_use]
pub fn first_order_polyline_gap_trapezoidal(setting: Setting, n: NonZeroUsize) -> f64 {
    polyline_gap(setting, n, Rule::Trapezoidal)
}

/// Bounds `E(γᵖˡ) − E_l,N(γᵖ)`, and `d² − E_l,N(γᵖ)`, in `m²`, by `d² (δ/2N) e Q = O(1/N)`.
///
/// Needs: the setting of Theorem 1.1, and a sequence that is stationary in its inner points with
/// `E_l,N ≤ d² e`, as a *global* minimiser is. Slack: attained at `N = 1` by an incline.
#[must_use]
pub fn first_order_polyline_gap_left(setting: Setting, n: NonZeroUsize) -> f64 {
    polyline_gap(setting, n, Rule::Left)
}

/// Bounds `E(γᵖˡ) − d²`, and `L(γᵖˡ)² − d²`, for the minimiser of `E_tra,N`, in `m²`:
/// the sum of the two gaps above, `O(1/N)` where the paper proves `O(1/√N)`.
///
/// Needs and slack: those of the two gaps.
#[must_use]
pub fn first_order_excess_trapezoidal(setting: Setting, n: NonZeroUsize) -> f64 {
    first_order_minimum_gap_trapezoidal(setting, n)
        + first_order_polyline_gap_trapezoidal(setting, n)
}

/// Bounds `E(γᵖˡ) − d²`, and `L(γᵖˡ)² − d²`, for the minimiser of `E_l,N`, in `m²`:
/// the sum of the two gaps above, `O(1/N)` where the paper proves `O(1/√N)`.
///
/// Needs and slack: those of the two gaps.
#[must_use]
pub fn first_order_excess_left(setting: Setting, n: NonZeroUsize) -> f64 {
    first_order_minimum_gap_left(setting, n) + first_order_polyline_gap_left(setting, n)
}

#[derive(Clone, Copy)]
enum Rule {
    Trapezoidal,
    Left,
}

/// `δ = L_H d / c₁^{3/2}`, a pure number.
fn delta(setting: Setting) -> f64 {
    let root = 1.0 / setting.constants().c1().sqrt();
    product([setting.constants().l_h(), setting.distance(), root, root, root])
}

/// `e − 1`, without the cancellation.
fn above_one(setting: Setting, n: NonZeroUsize, rule: Rule) -> f64 {
    let (delta, n, constants) = (delta(setting), n.get() as f64, setting.constants());
    let sampled = match rule {
        // One division by N after the sum.
        Rule::Trapezoidal => (0.25 * delta + 0.125 * delta * delta / n) / n,
        Rule::Left => 0.5 * delta / n,
    };
    sampled.min((constants.c2() - constants.c1()) / constants.c1())
}

/// `d² (k δ/N) e Q`.
fn polyline_gap(setting: Setting, n: NonZeroUsize, rule: Rule) -> f64 {
    let (delta, d) = (delta(setting), setting.distance());
    let e = 1.0 + above_one(setting, n, rule);
    let n = n.get() as f64;
    let k = match rule {
        Rule::Trapezoidal => 0.25,
        Rule::Left => 0.5,
    };
    let q = (n * e).sqrt().min(e.sqrt() + delta * e);
    product([d, d, k, delta, e, q]) / n
}

#[cfg(test)]
mod tests {
    use super::{
        first_order_excess_left, first_order_excess_trapezoidal, first_order_minimum_gap_left,
        first_order_minimum_gap_trapezoidal, first_order_polyline_gap_left,
        first_order_polyline_gap_trapezoidal,
    };
    use crate::{Constants, Setting};
    use std::num::NonZeroUsize;

    fn n(n: usize) -> NonZeroUsize {
        NonZeroUsize::new(n).expect("positive")
    }

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, `d² = 9`, and `κ` out of the way.
    fn setting() -> Setting {
        Setting::new(Constants::new(4.0, 400.0, 8.0).expect("in order"), 3.0, 2).expect("valid")
    }

    #[test]
    fn by_hand() {
        // N = 1: e = 1 + 3/4 + 9/8 = 23/8 and 1 + 3/2 = 5/2; Q is √e, the lesser.
        assert_eq!(first_order_minimum_gap_trapezoidal(setting(), n(1)), 9.0 * 1.875);
        assert_eq!(first_order_minimum_gap_left(setting(), n(1)), 9.0 * 1.5);
        let close = |value: f64, expected: f64| {
            // Some ten roundings.
            assert!((value / expected - 1.0).abs() < 2e-15, "{value} is not {expected}");
        };
        let gap = first_order_polyline_gap_trapezoidal(setting(), n(1));
        close(gap, 9.0 * 0.75 * 2.875_f64.powf(1.5));
        close(first_order_polyline_gap_left(setting(), n(1)), 9.0 * 1.5 * 2.5_f64.powf(1.5));
        // N = 36: e = 1 + 1/48 + 1/1152 and 1 + 1/24; Q is √e + 3e, below 6√e.
        let e: f64 = 1.0 + 1.0 / 48.0 + 1.0 / 1152.0;
        let gap = first_order_polyline_gap_trapezoidal(setting(), n(36));
        close(gap, 9.0 / 48.0 * e * (e.sqrt() + 3.0 * e));
        close(first_order_excess_trapezoidal(setting(), n(36)), 9.0 * (e - 1.0) + gap);
        let e: f64 = 25.0 / 24.0;
        let gap = first_order_polyline_gap_left(setting(), n(36));
        close(gap, 9.0 / 24.0 * e * (e.sqrt() + 3.0 * e));
        close(first_order_excess_left(setting(), n(36)), 9.0 / 24.0 + gap);
    }

    #[test]
    fn a_constant_metric_has_no_gap_and_kappa_caps_the_ceiling() {
        let flat = Setting::new(Constants::new(1.0, 2.0, 0.0).expect("in order"), 3.0, 2);
        assert_eq!(first_order_excess_trapezoidal(flat.expect("valid"), n(3)), 0.0);
        let steep = Setting::new(Constants::new(1.0, 2.0, 1e6).expect("in order"), 3.0, 2);
        assert_eq!(first_order_minimum_gap_left(steep.expect("valid"), n(3)), 9.0);
        let steep = Setting::new(Constants::new(2.0, 3.0, 1e6).expect("in order"), 3.0, 2);
        assert_eq!(first_order_minimum_gap_left(steep.expect("valid"), n(3)), 4.5);
        let touching = Setting::new(Constants::new(1.0, 2.0, 1e300).expect("in order"), 0.0, 2);
        assert_eq!(first_order_excess_left(touching.expect("valid"), n(3)), 0.0);
    }
}
