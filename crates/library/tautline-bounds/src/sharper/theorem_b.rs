//! Theorem B: bounds of order `1/N²`, in terms of `M_H`, for the trapezoidal rule and sequences
//! that are stationary with respect to their inner points.
//!
//! All functions of this module return `None` if `M_H` is unknown. With `μ = M_H d²/c₁²`:
//!
//! 1. *From above* (Lemma S.4). The energy of the sampled geodesic, expanded about the middle of
//!    each subinterval, has no terms of odd order: `min E_tra,N ≤ d² e₂` with
//!    `e₂ = min(e, 1 + (Gδ/3 + μ/24)/N²)` and the `e` of Theorem A.
//! 2. *The gap* (Lemma S.2). `|E(γᵖˡ) − E_tra,N| ≤ (M_H/24N²) mean |β|⁴ ≤ d² (μ/24N²) e₂ Q²` with
//!    `Q = min(√(Ne₂), √e₂ + δe₂)` by Lemma S.3.

use std::num::NonZeroUsize;

use super::theorem_a::greatest_speed;
use crate::{PaperRule, Setting, product::product, sharper::ceiling};

/// Bounds `min E_tra,N − d²`, in `m²`, by `d² (e₂ − 1) = O(1/N²)`.
///
/// Needs: as for Theorem A; in addition `DH` Lipschitz with `M_H`, and a *global* minimiser.
///
/// Overestimation: as `N → ∞`, this bound is larger than
/// [`theorem_d_minimum_gap`](crate::theorem_d_minimum_gap) by the factor
/// `(Gδ/3 + μ/24)/(G²/12 + μ/24)`.
#[must_use]
pub fn theorem_b_minimum_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let d = setting.distance();
    Some(product([d, d, ceiling::second_order(setting, n)?]))
}

/// Bounds both `|E(γᵖˡ) − E_tra,N(γᵖ)|` and `d² − E_tra,N(γᵖ)`, in `m²`, by
/// `d² (μ/24N²) e₂ Q² = O(1/N²)`.
///
/// Needs: a sequence with `E_tra,N ≤ d² e₂` that is stationary with respect to its inner points,
/// for example a *global* minimiser. Overestimation: the bound is attained at `N = 1` by a metric
/// that is quadratic along the chord.
#[must_use]
pub fn theorem_b_polyline_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let e = 1.0 + ceiling::second_order::<f64>(setting, n)?;
    let greatest = greatest_speed(setting.delta(), e, n);
    let count = n.get() as f64;
    Some(product([d, d, mu, e, greatest, greatest]) / (24.0 * count * count))
}

/// Bounds both `E(γᵖˡ) − d²` and `L(γᵖˡ)² − d²`, in `m²`, by the sum of the bounds on the two gaps,
/// which is `O(1/N²)`.
///
/// Needs and overestimation: as for the bounds on the two gaps.
#[must_use]
pub fn theorem_b_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    Some(theorem_b_minimum_gap(setting, n)? + theorem_b_polyline_gap(setting, n)?)
}

/// Returns `C₂`, in `m²`, for which `E(γᵖˡ) − d² ≤ C₂/N²` for every `N`.
///
/// ```text
/// C₂ = d² [Gδ/3 + (μ/24) (1 + ē (√ē + δē)²)],      ē = min(κ, 1 + δ/4 + Gδ/12)
/// ```
///
/// Needs: as for [`theorem_b_excess`], which does not exceed `C₂/N²`.
#[must_use]
pub fn theorem_b_constant(setting: Setting) -> Option<f64> {
    let (delta, mu, d) = (setting.delta(), setting.mu()?, setting.distance());
    let e = 1.0 + ceiling::first_order::<f64>(setting, PaperRule::Trapezoidal, NonZeroUsize::MIN);
    let greatest = e.sqrt() + product([delta, e]);
    let sampled = product([setting.bend() / 3.0, delta]);
    let gap = product([mu / 24.0, 1.0 + product([e, greatest, greatest])]);
    Some(product([d, d, sampled + gap]))
}

#[cfg(test)]
mod tests {
    use super::{
        theorem_b_constant, theorem_b_excess, theorem_b_minimum_gap, theorem_b_polyline_gap,
    };
    use crate::{
        Setting,
        by_hand::{self, constants, n, with_m_h},
    };

    fn close(value: Option<f64>, expected: f64) {
        // This allows for about ten roundings.
        by_hand::close(value, expected, 4e-15);
    }

    /// `c₁ = 4`, `L_H = 8`, `M_H = 32`, `d = 3`: `δ = 3`, `μ = 18`, `d² = 9`.
    fn setting() -> Setting {
        Setting::new(with_m_h(4.0, 4e6, 8.0, 32.0), 3.0, 2).expect("valid")
    }

    #[test]
    fn by_hand() {
        // N = 36: e₂ = 1 + (9/2 + 3/4)/1296, Q = √e₂ + 3e₂.
        let e: f64 = 1.0 + 5.25 / 1296.0;
        close(theorem_b_minimum_gap(setting(), n(36)), 9.0 * 5.25 / 1296.0);
        let gap = 9.0 * 0.75 / 1296.0 * e * (e.sqrt() + 3.0 * e).powi(2);
        close(theorem_b_polyline_gap(setting(), n(36)), gap);
        close(theorem_b_excess(setting(), n(36)), 9.0 * 5.25 / 1296.0 + gap);
        // ē = 23/8.
        let e: f64 = 2.875;
        let constant = 9.0 * (4.5 + 0.75 * (1.0 + e * (e.sqrt() + 3.0 * e).powi(2)));
        close(theorem_b_constant(setting()), constant);
    }

    #[test]
    fn at_one_chord_the_ceiling_is_that_of_theorem_a() {
        // e = 23/8 is less than 1 + 5.25; Q = √e.
        let gap = 9.0 * 0.75 * 2.875 * 2.875;
        close(theorem_b_polyline_gap(setting(), n(1)), gap);
        close(theorem_b_excess(setting(), n(1)), 9.0 * 1.875 + gap);
    }

    #[test]
    fn there_is_none_without_m_h() {
        let setting = Setting::new(constants(1.0, 2.0, 1.0), 1.0, 2).expect("valid");
        assert_eq!(theorem_b_minimum_gap(setting, n(8)), None);
        assert_eq!(theorem_b_polyline_gap(setting, n(8)), None);
        assert_eq!(theorem_b_excess(setting, n(8)), None);
        assert_eq!(theorem_b_constant(setting), None);
    }
}
