//! Theorem C: bounds of order `1/N` from the energy alone, whether the sequence is stationary or
//! not.
//!
//! With `Λ = L_H/c₁^{3/2}`, `k = ¼` for the trapezoidal rule, `k = ½` for the left-endpoint rule:
//!
//! 1. *Length* (Lemma S.5). On a chord the mean of `βᵀHβ` is at most `q² + (kΛ/N) q³`, and the
//!    square root is concave. Since `√(s + c s^{3/2})` is concave too,
//!    `L(γᵖˡ)² ≤ E_N + (kΛ/N) E_N^{3/2}` for every sequence.
//! 2. *From below*. `d ≤ L(γᵖˡ)` for every admissible sequence; solve the resulting inequality for
//!    `E_N`.
//! 3. *Speeds* (Lemma S.5). If `mean q² ≤ d² e`, the variance of the speeds is `O(1/N)`, and
//!    `mean q³ ≤ d³ m₃` with `m₃ → 1`.
//! 4. *The gap* (Lemma S.2). `|E(γᵖˡ) − E_N| ≤ (k L_H/N) mean |β|³ ≤ d² (kδ/N) m₃`.

use std::num::NonZeroUsize;

use super::{ceiling, spread::Spread};
use crate::{PaperRule, Setting, product::product, theorem_a_minimum_gap};

/// Bounds `d² − E_N(γᵖ)` for *every* admissible sequence, in `m²`, by `O(1/N)`.
///
/// ```text
/// E_N  ≥  d² s²,      s² + (kδ/N) s³ = 1,      k = ¼ (trapezoidal), ½ (left endpoint)
/// ```
///
/// which is at least `d² (1 − kδ/N)`.
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and ends in their sets. Neither a minimiser nor `c₂`
/// is needed.
///
/// Overestimation: the bound is attained for every `N` in the limit `δ → 0`, over valleys in the
/// middle of the chords (trapezoidal) and up an incline (left endpoint).
#[must_use]
pub fn theorem_c_deficit(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let d = setting.distance();
    let a = product([rule.mean_distance(), setting.delta()]) / n.get() as f64;
    // 1 − s² = a s³, computed without cancellation; s = 0 if δ overflows.
    let lost = if a.is_finite() { product([a, root(a).powi(3)]) } else { 1.0 };
    product([d, d, lost])
}

/// Returns the positive root of `s² + a s³ = 1` for `a ≥ 0`, by Newton's method from above. The
/// function is convex, so the iterates stay above the root.
fn root(a: f64) -> f64 {
    let mut s = a.powf(-1.0 / 3.0).min(1.0);
    loop {
        let next = s - (s * s * (1.0 + a * s) - 1.0) / (s * (2.0 + 3.0 * a * s));
        if !(next < s) {
            return s;
        }
        s = next;
    }
}

/// Bounds `|E(γᵖˡ) − E_N(γᵖ)|`, in `m²`, by `d² (kδ/N) m₃ = O(1/N)`.
///
/// Needs: as for [`theorem_c_deficit`], and `E_N(γᵖ) ≤ d² e` with the `e` of Theorem A, which every
/// *global* minimiser satisfies. Overestimation: at `N = 1` as for
/// [`theorem_a_polyline_gap`](crate::theorem_a_polyline_gap), which this bound never exceeds. For
/// large `δ` it is `O(δ/N)` instead of `O(δ²/N)`.
#[must_use]
pub fn theorem_c_polyline_gap(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let (delta, d) = (setting.delta(), setting.distance());
    let surplus: f64 = ceiling::first_order(setting, rule, n);
    let spread = Spread::of_first_order(setting, rule, n, surplus);
    product([d, d, rule.mean_distance(), delta, spread.cube]) / n.get() as f64
}

/// Bounds `E(γᵖˡ) − d²`, in `m²`, for every admissible sequence with `E_N ≤ d² e`.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  d² [e − 1 + (kδ/N) m₃]  ~  d² δ/2N (trapezoidal),  d² δ/N (left endpoint)
/// ```
///
/// Needs: as for [`theorem_c_polyline_gap`]. Overestimation: the bound is attained for every `N` in
/// the limit `δ → 0`.
#[must_use]
pub fn theorem_c_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    theorem_a_minimum_gap(setting, rule, n) + theorem_c_polyline_gap(setting, rule, n)
}

/// Bounds `L(γᵖˡ)² − d²`, in `m²`, for every admissible sequence with `E_N ≤ d² e`.
///
/// ```text
/// L(γᵖˡ)² − d²  ≤  d² [e − 1 + (kδ/N) e^{3/2}]
/// ```
///
/// Needs and overestimation: as for [`theorem_c_excess`], which is at least as large.
#[must_use]
pub fn theorem_c_length_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let (delta, d) = (setting.delta(), setting.distance());
    let surplus: f64 = ceiling::first_order(setting, rule, n);
    let cube = (1.0 + surplus).powf(1.5);
    let gap = product([rule.mean_distance(), delta, cube]) / n.get() as f64;
    product([d, d, surplus + gap])
}

#[cfg(test)]
mod tests {
    use super::{
        root, theorem_c_deficit, theorem_c_excess, theorem_c_length_excess, theorem_c_polyline_gap,
    };
    use crate::{
        PaperRule, Setting,
        by_hand::{self, constants, n},
        theorem_a_excess,
    };

    const TRA: PaperRule = PaperRule::Trapezoidal;
    const LEFT: PaperRule = PaperRule::LeftEndpoint;

    fn close(value: f64, expected: f64) {
        // This allows for about twenty roundings, the first of which are relative to a variance of
        // 1/40.
        by_hand::close(value, expected, 4e-14);
    }

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, `d² = 9`.
    fn setting(c2: f64) -> Setting {
        Setting::new(constants(4.0, c2, 8.0), 3.0, 2).expect("valid")
    }

    #[test]
    fn by_hand() {
        // s = ½ is the root for a = 6: this is δ = 12 at N = 1 (left endpoint) and δ = 48 at N = 2.
        assert_eq!(root(6.0), 0.5);
        assert_eq!(root(0.0), 1.0);
        let far = setting(400.0).with_distance(12.0).expect("a distance");
        assert_eq!(theorem_c_deficit(far, LEFT, n(1)), 144.0 * 0.75);
        let farther = setting(400.0).with_distance(48.0).expect("a distance");
        assert_eq!(theorem_c_deficit(farther, TRA, n(2)), 2304.0 * 0.75);
        for a in [1e-9, 0.3, 1.5, 1e3, 1e60] {
            let s = root(a);
            assert!((s * s + a * s * s * s - 1.0).abs() < 1e-14, "{a}: {s}");
        }
        // e = 1 + 1/4 at N = 6 (left): e − 1 + (1/4)(5/4)^{3/2}.
        let excess = theorem_c_length_excess(setting(400.0), LEFT, n(6));
        close(excess, 9.0 * (0.25 + 0.25 * 1.25_f64.powf(1.5)));
        // κ − 1 = 1/80 caps e at N = 30: x = 3·(81/80)/240, R² = 29v.
        let e = 1.0125_f64;
        let cube = |x: f64| {
            let v = e - (1.0 - x).powi(2);
            e.powf(1.5) + 1.5 * e.sqrt() * v + (29.0 * v).sqrt() * v
        };
        let (gap, tame) = (3.0 / 120.0 * cube(3.0 * e / 240.0), setting(4.05));
        close(theorem_c_polyline_gap(tame, TRA, n(30)), 9.0 * gap);
        close(theorem_c_excess(tame, TRA, n(30)), 9.0 * (0.0125 + gap));
        close(theorem_c_polyline_gap(tame, LEFT, n(30)), 9.0 * 3.0 / 60.0 * cube(3.0 * e / 120.0));
        // At N = 1 there is only one speed.
        close(theorem_c_polyline_gap(tame, LEFT, n(1)), 9.0 * 1.5 * e.powf(1.5));
    }

    /// As `N → ∞` the bounds behave like `δ/2N` and `δ/N`; Theorem A has `(δ/4 + (δ/4)(1 + δ))/N`
    /// and twice this number.
    #[test]
    fn the_leading_constant_is_linear_in_delta() {
        let huge = 1 << 40;
        for (rule, leading, older) in [(TRA, 1.5, 3.75), (LEFT, 3.0, 7.5)] {
            let at = |bound: f64| bound / 9.0 * huge as f64;
            let new = at(theorem_c_excess(setting(400.0), rule, n(huge)));
            // The next terms are of relative order 1/N, that of m₃ too: v = O(1/N), and
            // √N v^{3/2} = O(1/N). Their factors are below 50.
            let next = 50.0 / huge as f64;
            assert!((new / leading - 1.0).abs() < next, "{new}");
            let old = at(theorem_a_excess(setting(400.0), rule, n(huge)));
            assert!((old / older - 1.0).abs() < next, "{old}");
        }
    }

    #[test]
    fn overflow_gives_no_nan_and_no_more_than_d_squared_is_lost() {
        let wild = Setting::new(constants(1e-300, 1.0, 1e300), 1e4, 2).expect("valid");
        assert_eq!(theorem_c_deficit(wild, TRA, n(7)), 1e8);
        assert_eq!(theorem_c_excess(wild, TRA, n(7)), f64::INFINITY);
        assert_eq!(theorem_c_length_excess(wild, TRA, n(7)), f64::INFINITY);
        let touching = Setting::new(constants(1.0, 2.0, 1e300), 0.0, 2).expect("valid");
        assert_eq!(theorem_c_deficit(touching, LEFT, n(7)), 0.0);
        assert_eq!(theorem_c_excess(touching, LEFT, n(7)), 0.0);
        assert_eq!(theorem_c_length_excess(touching, LEFT, n(7)), 0.0);
    }
}
