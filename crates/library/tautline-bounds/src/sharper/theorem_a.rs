//! Theorem A: bounds of order `1/N` for sequences that are stationary with respect to their inner
//! points.
//!
//! With `δ = L_H d / c₁^{3/2}`, the [`G`](Setting::bend) of Lemma S.1, `κ = c₂/c₁`, and `k = ¼` for
//! the trapezoidal rule, `k = ½` for the left-endpoint rule:
//!
//! 1. *From above* (Lemma S.4). A minimal geodesic sampled at `tₙ = n/N` is admissible, so
//!    `min E_N ≤ d² e` with
//!
//!    ```text
//!    e = min(κ, 1 + δ/4N + Gδ/12N²)  (trapezoidal),     e = min(κ, 1 + δ/2N)  (left endpoint)
//!    ```
//! 2. *Speeds* (Lemma S.3). If the inner points are stationary, `max qₙ ≤ d Q` with
//!    `Q = min(√(Ne), √e + δe)`.
//! 3. *The gap* (Lemma S.2).
//!    `|E(γᵖˡ) − E_N| ≤ (k L_H/N) mean |βₙ|³ ≤ (k L_H/N c₁^{3/2}) max qₙ · E_N`, which is
//!    `d² (kδ/N) e Q`.

use std::num::NonZeroUsize;

use crate::{PaperRule, Setting, product::product, sharper::ceiling};

/// Bounds `min E_N − d²`, in `m²`, by `d² (e − 1) = O(1/N)`.
///
/// ```text
/// min E_tra,N − d²  ≤  d² min(κ − 1, δ/4N + Gδ/12N²),      min E_l,N − d²  ≤  d² min(κ − 1, δ/2N)
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser. `c₂` enters only through `κ`, and
/// `D` matters only if it is 1. For an isotropic metric, [`G`](Setting::bend) uses `M_H` if it is
/// known.
///
/// Overestimation: neither `δ/4` nor `δ/2` can be improved for all metrics with these constants.
/// For a fixed smooth metric the gap is of order `1/N²` for the trapezoidal rule.
#[must_use]
pub fn theorem_a_minimum_gap(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let d = setting.distance();
    product([d, d, ceiling::first_order(setting, rule, n)])
}

/// Bounds both `E(γᵖˡ) − E_N(γᵖ)` and `d² − E_N(γᵖ)`, in `m²`, by `d² (kδ/N) e Q = O(1/N)`.
///
/// Needs: the setting of Theorem 1.1, and a sequence with `E_N ≤ d² e` that is stationary with
/// respect to its inner points, for example a *global* minimiser. `e` and `Q` are as in the
/// derivation above.
///
/// Overestimation: the bound is attained at `N = 1` by a tent (trapezoidal) and by an incline (left
/// endpoint).
#[must_use]
pub fn theorem_a_polyline_gap(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let (delta, d) = (setting.delta(), setting.distance());
    let e = 1.0 + ceiling::first_order::<f64>(setting, rule, n);
    let greatest = greatest_speed(delta, e, n);
    product([d, d, rule.mean_distance(), delta, e, greatest]) / n.get() as f64
}

/// Bounds both `E(γᵖˡ) − d²` and `L(γᵖˡ)² − d²`, in `m²`, by the sum of the bounds on the two gaps.
/// It is `O(1/N)`, whereas the paper proves `O(1/√N)`.
///
/// Needs and overestimation: as for the bounds on the two gaps.
#[must_use]
pub fn theorem_a_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    theorem_a_minimum_gap(setting, rule, n) + theorem_a_polyline_gap(setting, rule, n)
}

/// Returns `C₁`, in `m²`, for which `E(γᵖˡ) − d² ≤ C₁/N` for every `N`.
///
/// ```text
/// C₁ = d² [δ/4 + Gδ/12 + (δ/4) ē (√ē + δē)]    (trapezoidal),      ē = e at N = 1
/// C₁ = d² [δ/2 + (δ/2) ē (√ē + δē)]             (left endpoint)
/// ```
///
/// Needs: as for [`theorem_a_excess`], which does not exceed `C₁/N`.
#[must_use]
pub fn theorem_a_constant(setting: Setting, rule: PaperRule) -> f64 {
    let (delta, d, k) = (setting.delta(), setting.distance(), rule.mean_distance());
    let e = 1.0 + ceiling::first_order::<f64>(setting, rule, NonZeroUsize::MIN);
    let sampled = match rule {
        PaperRule::Trapezoidal => 0.25 * delta + product([setting.bend() / 12.0, delta]),
        PaperRule::LeftEndpoint => 0.5 * delta,
    };
    let gap = product([k, delta, e, e.sqrt() + product([delta, e])]);
    product([d, d, sampled + gap])
}

/// Returns `Q = min(√(Ne), √e + δe)`.
pub(super) fn greatest_speed(delta: f64, e: f64, n: NonZeroUsize) -> f64 {
    (n.get() as f64 * e).sqrt().min(e.sqrt() + product([delta, e]))
}

#[cfg(test)]
mod tests {
    use super::{
        theorem_a_constant, theorem_a_excess, theorem_a_minimum_gap, theorem_a_polyline_gap,
    };
    use crate::{
        PaperRule, Setting,
        by_hand::{self, constants, n},
    };

    const TRA: PaperRule = PaperRule::Trapezoidal;
    const LEFT: PaperRule = PaperRule::LeftEndpoint;

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, `d² = 9`, and a large `κ`.
    fn setting() -> Setting {
        Setting::new(constants(4.0, 400.0, 8.0), 3.0, 2).expect("valid")
    }

    fn close(value: f64, expected: f64) {
        // This allows for about ten roundings.
        by_hand::close(value, expected, 4e-15);
    }

    #[test]
    fn by_hand() {
        // N = 1: e = 1 + 3/4 + 9/8 = 23/8 and 1 + 3/2 = 5/2; Q = √e is the smaller.
        close(theorem_a_minimum_gap(setting(), TRA, n(1)), 9.0 * 1.875);
        close(theorem_a_minimum_gap(setting(), LEFT, n(1)), 9.0 * 1.5);
        let gap = theorem_a_polyline_gap(setting(), TRA, n(1));
        close(gap, 9.0 * 0.75 * 2.875_f64.powf(1.5));
        close(theorem_a_polyline_gap(setting(), LEFT, n(1)), 9.0 * 1.5 * 2.5_f64.powf(1.5));
        // N = 36: e = 1 + 1/48 + 1/1152 and 1 + 1/24; Q = √e + 3e is below 6√e.
        let e: f64 = 1.0 + 1.0 / 48.0 + 1.0 / 1152.0;
        let gap = theorem_a_polyline_gap(setting(), TRA, n(36));
        close(gap, 9.0 / 48.0 * e * (e.sqrt() + 3.0 * e));
        close(theorem_a_excess(setting(), TRA, n(36)), 9.0 * (e - 1.0) + gap);
        let e: f64 = 25.0 / 24.0;
        let gap = theorem_a_polyline_gap(setting(), LEFT, n(36));
        close(gap, 9.0 / 24.0 * e * (e.sqrt() + 3.0 * e));
        close(theorem_a_excess(setting(), LEFT, n(36)), 9.0 / 24.0 + gap);
        // ē = 23/8 and 5/2.
        let e: f64 = 2.875;
        close(theorem_a_constant(setting(), TRA), 9.0 * (1.875 + 0.75 * e * (e.sqrt() + 3.0 * e)));
        let e: f64 = 2.5;
        close(theorem_a_constant(setting(), LEFT), 9.0 * (1.5 + 1.5 * e * (e.sqrt() + 3.0 * e)));
    }

    #[test]
    fn on_the_line_geodesics_bend_less() {
        let line = Setting::new(setting().constants(), 3.0, 1).expect("valid");
        // 3/4 + 9/24 at N = 1.
        close(theorem_a_minimum_gap(line, TRA, n(1)), 9.0 * 1.125);
    }

    #[test]
    fn a_constant_metric_has_no_gap_and_kappa_caps_the_ceiling() {
        let setting = |c1, c2, l_h, d| Setting::new(constants(c1, c2, l_h), d, 2).expect("valid");
        let flat = setting(1.0, 2.0, 0.0, 3.0);
        assert_eq!(theorem_a_excess(flat, TRA, n(3)), 0.0);
        assert_eq!(theorem_a_constant(flat, TRA), 0.0);
        assert_eq!(theorem_a_minimum_gap(setting(1.0, 2.0, 1e6, 3.0), LEFT, n(3)), 9.0);
        assert_eq!(theorem_a_minimum_gap(setting(2.0, 3.0, 1e6, 3.0), LEFT, n(3)), 4.5);
        let touching = setting(1.0, 2.0, 1e300, 0.0);
        assert_eq!(theorem_a_excess(touching, LEFT, n(3)), 0.0);
        assert_eq!(theorem_a_constant(touching, LEFT), 0.0);
    }
}
