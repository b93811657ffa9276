//! Theorem D: order `1/N²` for the trapezoidal rule from the energy alone, where `M_H` is known.
//!
//! 1. *From above* (Lemma S.4). Between the geodesic and its interpolation the energy differs by
//!    the second variation alone, and from there to `E_tra,N` by the curvature of `H`:
//!
//!    ```text
//!    ê = 1 + (1/N²) [G² (min(κ, (1 + δ/2N)²)/12 + δ/(√360 N) + μ/240N²) + μ/24]
//!    ```
//!
//!    of which, and of the ceilings of Theorems A and B, `ε` is the least.
//! 2. *Length* (Lemma S.5). `L(γᵖˡ)² ≤ E_tra,N + (M_H/24c₁²N²) E_tra,N²` for every sequence.
//! 3. *Speeds* (Lemma S.5). `d ≤ L(γᵖˡ) ≤ mean q + (M_H/48c₁²N²) mean q³` leaves a variance of
//!    `O(1/N²)` to the speeds, and `mean q⁴ ≤ d⁴ m₄` with `m₄ → 1`.
//! 4. *The gap* (Lemma S.2). `|E(γᵖˡ) − E_tra,N| ≤ (M_H/24N²) mean |β|⁴ ≤ d² (μ/24N²) m₄`.

use std::num::NonZeroUsize;

use super::{ceiling, spread::Spread};
use crate::{Setting, product::product};

/// Bounds `min E_tra,N − d²`, in `m²`, by `d² (ε − 1) = O(1/N²)`; `None` if `M_H` is not known.
///
/// Needs: as Theorem B, and a *global* minimiser.
///
/// Overestimation: as `N → ∞` it is `d² (G²/12 + μ/24)/N²`, which is the leading term of the gap of
/// a single metric with its two integrals estimated by suprema.
#[must_use]
pub fn theorem_d_minimum_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let d = setting.distance();
    Some(product([d, d, ceiling::second_variation(setting, n)?]))
}

/// Bounds `d² − E_tra,N(γᵖ)` for *every* admissible sequence, in `m²`, by `O(1/N²)`; `None` if
/// `M_H` is not known.
///
/// ```text
/// E_tra,N  ≥  2d²/(1 + √(1 + μ/6N²))  ≥  d² (1 − μ/24N²)
/// ```
///
/// `s + (μ/24N²) s² ≥ 1` for `s = E_tra,N/d²`, since `d ≤ L(γᵖˡ)`.
///
/// Needs: `H ≥ c₁`, `DH` Lipschitz with `M_H`; ends in their sets. No minimiser, and no `L_H`.
/// Overestimation: none as `μ → 0`, at `N = 1` over a metric that is quadratic along the chord.
#[must_use]
pub fn theorem_d_deficit(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let count = n.get() as f64;
    let c = mu / (24.0 * count * count);
    let s = 2.0 / (1.0 + (1.0 + 4.0 * c).sqrt());
    // 1 − s = c s², without the cancellation; nothing is left where μ overflows.
    let lost = if c.is_finite() { product([c, s, s]) } else { 1.0 };
    Some(product([d, d, lost]))
}

/// Bounds `|E(γᵖˡ) − E_tra,N(γᵖ)|`, in `m²`, by `d² (μ/24N²) m₄ = O(1/N²)`, where
/// `E_tra,N(γᵖ) ≤ d² ε`; `None` if `M_H` is not known.
///
/// Needs: as [`theorem_d_deficit`], and an energy of at most `d² ε`; a *global* minimiser has it,
/// and need not be stationary. Overestimation: none at `N = 1`, for a metric that is quadratic
/// along the chord.
#[must_use]
pub fn theorem_d_polyline_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let surplus = ceiling::second_variation(setting, n)?;
    let spread = Spread::of_second_order(setting, n, surplus)?;
    let count = n.get() as f64;
    Some(product([d, d, mu, spread.fourth]) / (24.0 * count * count))
}

/// Bounds `E(γᵖˡ) − d²`, in `m²`, for every admissible sequence with `E_tra,N ≤ d² ε`:
/// `d² (ε − 1)` and the gap above, `O(1/N²)`; `None` if `M_H` is not known.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  d² [ε − 1 + (μ/24N²) m₄]  ~  (d²/N²) (G²/12 + μ/12)
/// ```
///
/// Needs: as [`theorem_d_polyline_gap`]. Overestimation: `μ/12` cannot be improved at `N = 1`.
#[must_use]
pub fn theorem_d_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    Some(theorem_d_minimum_gap(setting, n)? + theorem_d_polyline_gap(setting, n)?)
}

/// Bounds `L(γᵖˡ)² − d²`, in `m²`, for every admissible sequence with `E_tra,N ≤ d² ε`; `None` if
/// `M_H` is not known.
///
/// ```text
/// L(γᵖˡ)² − d²  ≤  d² [ε − 1 + (μ/24N²) ε²]
/// ```
///
/// Needs: as [`theorem_d_excess`], which is no smaller. Overestimation: as there.
#[must_use]
pub fn theorem_d_length_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let surplus = ceiling::second_variation(setting, n)?;
    let (e, count) = (1.0 + surplus, n.get() as f64);
    let gap = product([mu, e, e]) / (24.0 * count * count);
    Some(product([d, d, surplus + gap]))
}

#[cfg(test)]
mod tests {
    use super::{
        theorem_d_deficit, theorem_d_excess, theorem_d_length_excess, theorem_d_minimum_gap,
        theorem_d_polyline_gap,
    };
    use crate::{Constants, Setting};
    use std::num::NonZeroUsize;

    fn n(n: usize) -> NonZeroUsize {
        NonZeroUsize::new(n).expect("positive")
    }

    fn close(value: Option<f64>, expected: f64) {
        let value = value.expect("M_H is known");
        // Some twenty roundings.
        assert!((value / expected - 1.0).abs() < 8e-15, "{value} is not {expected}");
    }

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, `d² = 9`, and `μ = 9 m_h/16`.
    fn setting(c2: f64, m_h: f64) -> Setting {
        let constants = Constants::new(4.0, c2, 8.0).and_then(|c| c.with_m_h(m_h));
        Setting::new(constants.expect("in order").on_a_region(), 3.0, 1).expect("valid")
    }

    #[test]
    fn one_chord_by_hand() {
        // κ − 1 = 1/8 caps ε, and of one chord m₃ = ε^{3/2}, m₄ = ε²; μ = 18.
        let one = setting(4.5, 32.0);
        close(theorem_d_minimum_gap(one, n(1)), 9.0 * 0.125);
        close(theorem_d_polyline_gap(one, n(1)), 9.0 * 0.75 * 1.125 * 1.125);
        close(theorem_d_excess(one, n(1)), 9.0 * (0.125 + 0.75 * 1.125 * 1.125));
        // Of one chord the length is the root of the energy.
        close(theorem_d_length_excess(one, n(1)), 9.0 * (0.125 + 0.75 * 1.125 * 1.125));
        // 1 + 18/6 = 4: 2/3 is left.
        close(theorem_d_deficit(one, n(1)), 3.0);
    }

    /// `(G²/12 + μ/12)/N²` as `N → ∞`, and `μ/24` from below.
    #[test]
    fn the_leading_constants() {
        let (setting, huge) = (setting(4e6, 32.0), 1_usize << 26);
        let at = |bound: Option<f64>| bound.expect("M_H") / 9.0 * (huge as f64).powi(2);
        // The next terms are of the relative order N⁻¹ and N^{-1/2}.
        for (value, leading) in [
            (at(theorem_d_minimum_gap(setting, n(huge))), 2.25 / 12.0 + 18.0 / 24.0),
            (at(theorem_d_excess(setting, n(huge))), 2.25 / 12.0 + 18.0 / 12.0),
            (at(theorem_d_length_excess(setting, n(huge))), 2.25 / 12.0 + 18.0 / 12.0),
            (at(theorem_d_deficit(setting, n(huge))), 18.0 / 24.0),
        ] {
            assert!((value / leading - 1.0).abs() < 1e-5, "{value} is not {leading}");
        }
    }

    #[test]
    fn there_is_none_without_m_h_and_nothing_where_the_ends_touch() {
        let constants = Constants::new(1.0, 2.0, 1.0).expect("in order");
        let unknown = Setting::new(constants, 1.0, 2).expect("valid");
        assert_eq!(theorem_d_minimum_gap(unknown, n(8)), None);
        assert_eq!(theorem_d_deficit(unknown, n(8)), None);
        assert_eq!(theorem_d_polyline_gap(unknown, n(8)), None);
        assert_eq!(theorem_d_excess(unknown, n(8)), None);
        assert_eq!(theorem_d_length_excess(unknown, n(8)), None);
        let touching = setting(4.5, 32.0).with_distance(0.0).expect("a distance");
        assert_eq!(theorem_d_excess(touching, n(8)), Some(0.0));
        assert_eq!(theorem_d_deficit(touching, n(8)), Some(0.0));
        let wild = Constants::new(1e-300, 1.0, 1e300).and_then(|c| c.with_m_h(1e300));
        let wild = Setting::new(wild.expect("in order"), 1e4, 2).expect("valid");
        assert_eq!(theorem_d_deficit(wild, n(8)), Some(1e8));
        assert_eq!(theorem_d_excess(wild, n(8)), Some(f64::INFINITY));
        assert_eq!(theorem_d_length_excess(wild, n(8)), Some(f64::INFINITY));
    }
}
