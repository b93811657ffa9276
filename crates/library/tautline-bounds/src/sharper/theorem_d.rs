//! Theorem D: bounds of order `1/N²` for the trapezoidal rule from the energy alone, in terms of
//! `M_H`.
//!
//! All of these functions return `None` if `M_H` is unknown.
//!
//! 1. *From above* (Lemma S.4). The energies of the geodesic and of its interpolation differ by the
//!    second variation, and the energy of the interpolation differs from `E_tra,N` by the curvature
//!    of `H`:
//!
//!    ```text
//!    ê = 1 + (1/N²) [G² (min(κ, (1 + δ/2N)²)/12 + δ/(√360 N) + μ/240N²) + μ/24]
//!    ```
//!
//!    The ceiling `ε` is the least of `ê` and the ceilings of Theorems A and B.
//! 2. *Length* (Lemma S.5). `L(γᵖˡ)² ≤ E_tra,N + (M_H/24c₁²N²) E_tra,N²` for every sequence.
//! 3. *Speeds* (Lemma S.5). By `d ≤ L(γᵖˡ) ≤ mean q + (M_H/48c₁²N²) mean q³` the variance of the
//!    speeds is `O(1/N²)`, and `mean q⁴ ≤ d⁴ m₄` with `m₄ → 1`.
//! 4. *The gap* (Lemma S.2). `|E(γᵖˡ) − E_tra,N| ≤ (M_H/24N²) mean |β|⁴ ≤ d² (μ/24N²) m₄`.

use std::num::NonZeroUsize;

use super::{ceiling, spread::Spread};
use crate::{Setting, product::product};

/// Bounds `min E_tra,N − d²`, in `m²`, by `d² (ε − 1) = O(1/N²)`.
///
/// Needs: as for Theorem B, and a *global* minimiser.
///
/// Overestimation: as `N → ∞` the bound is `d² (G²/12 + μ/24)/N²`. This is the leading term of the
/// gap for a single metric, with its two integrals replaced by suprema.
#[must_use]
pub fn theorem_d_minimum_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let d = setting.distance();
    Some(product([d, d, ceiling::second_variation(setting, n)?]))
}

/// Bounds `d² − E_tra,N(γᵖ)` for *every* admissible sequence, in `m²`, by `O(1/N²)`.
///
/// ```text
/// E_tra,N  ≥  2d²/(1 + √(1 + μ/6N²))  ≥  d² (1 − μ/24N²)
/// ```
///
/// The proof uses `s + (μ/24N²) s² ≥ 1` for `s = E_tra,N/d²`, which follows from `d ≤ L(γᵖˡ)`.
///
/// Needs: `H ≥ c₁`, `DH` Lipschitz with `M_H`, and ends in their sets. Neither a minimiser nor
/// `L_H` is needed. Overestimation: the bound is attained in the limit `μ → 0`, at `N = 1` over a
/// metric that is quadratic along the chord.
#[must_use]
pub fn theorem_d_deficit(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let count = n.get() as f64;
    let c = mu / (24.0 * count * count);
    let s = 2.0 / (1.0 + (1.0 + 4.0 * c).sqrt());
    // 1 − s = c s², computed without cancellation; s = 0 if μ overflows.
    let lost = if c.is_finite() { product([c, s, s]) } else { 1.0 };
    Some(product([d, d, lost]))
}

/// Bounds `|E(γᵖˡ) − E_tra,N(γᵖ)|`, in `m²`, by `d² (μ/24N²) m₄ = O(1/N²)`.
///
/// Needs: as for [`theorem_d_deficit`], and `E_tra,N(γᵖ) ≤ d² ε`, which every *global* minimiser
/// satisfies. Overestimation: the bound is attained at `N = 1` by a metric that is quadratic along
/// the chord.
#[must_use]
pub fn theorem_d_polyline_gap(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let surplus: f64 = ceiling::second_variation(setting, n)?;
    let spread = Spread::of_second_order(setting, n, surplus)?;
    let count = n.get() as f64;
    Some(product([d, d, mu, spread.fourth]) / (24.0 * count * count))
}

/// Bounds `E(γᵖˡ) − d²`, in `m²`, for every admissible sequence with `E_tra,N ≤ d² ε`.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  d² [ε − 1 + (μ/24N²) m₄]  ~  (d²/N²) (G²/12 + μ/12)
/// ```
///
/// Needs: as for [`theorem_d_polyline_gap`]. Overestimation: at `N = 1` the term `μ/12` cannot be
/// improved.
#[must_use]
pub fn theorem_d_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    Some(theorem_d_minimum_gap(setting, n)? + theorem_d_polyline_gap(setting, n)?)
}

/// Bounds `L(γᵖˡ)² − d²`, in `m²`, for every admissible sequence with `E_tra,N ≤ d² ε`.
///
/// ```text
/// L(γᵖˡ)² − d²  ≤  d² [ε − 1 + (μ/24N²) ε²]
/// ```
///
/// Needs and overestimation: as for [`theorem_d_excess`], which is at least as large.
#[must_use]
pub fn theorem_d_length_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    let (mu, d) = (setting.mu()?, setting.distance());
    let surplus: f64 = ceiling::second_variation(setting, n)?;
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
    use crate::{
        Setting,
        by_hand::{self, constants, n, with_m_h},
    };

    fn close(value: Option<f64>, expected: f64) {
        // This allows for about twenty roundings.
        by_hand::close(value, expected, 8e-15);
    }

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, `d² = 9`, and `μ = 9 m_h/16`.
    fn setting(c2: f64, m_h: f64) -> Setting {
        Setting::new(with_m_h(4.0, c2, 8.0, m_h).on_a_region(), 3.0, 1).expect("valid")
    }

    #[test]
    fn one_chord_by_hand() {
        // κ − 1 = 1/8 caps ε; for a single chord m₃ = ε^{3/2} and m₄ = ε²; μ = 18.
        let one = setting(4.5, 32.0);
        close(theorem_d_minimum_gap(one, n(1)), 9.0 * 0.125);
        close(theorem_d_polyline_gap(one, n(1)), 9.0 * 0.75 * 1.125 * 1.125);
        close(theorem_d_excess(one, n(1)), 9.0 * (0.125 + 0.75 * 1.125 * 1.125));
        // For a single chord E = L².
        close(theorem_d_length_excess(one, n(1)), 9.0 * (0.125 + 0.75 * 1.125 * 1.125));
        // 1 + 18/6 = 4, so the deficit is d² (1 − 2/3).
        close(theorem_d_deficit(one, n(1)), 3.0);
    }

    /// As `N → ∞` the bound from above behaves like `(G²/12 + μ/12)/N²`, from below like `μ/24N²`.
    #[test]
    fn the_leading_constants() {
        let (setting, huge) = (setting(4e6, 32.0), 1_usize << 26);
        let at = |bound: Option<f64>| bound.expect("M_H") / 9.0 * (huge as f64).powi(2);
        // The next terms are of relative order 1/N, from (1 + δ/2N)² and δ/(√360 N), with factors
        // below 2; those of m₄ are of order 1/N², since v = O(1/N²).
        let next = 2.0 / huge as f64;
        for (value, leading) in [
            (at(theorem_d_minimum_gap(setting, n(huge))), 2.25 / 12.0 + 18.0 / 24.0),
            (at(theorem_d_excess(setting, n(huge))), 2.25 / 12.0 + 18.0 / 12.0),
            (at(theorem_d_length_excess(setting, n(huge))), 2.25 / 12.0 + 18.0 / 12.0),
            (at(theorem_d_deficit(setting, n(huge))), 18.0 / 24.0),
        ] {
            assert!((value / leading - 1.0).abs() < next, "{value} is not {leading}");
        }
    }

    #[test]
    fn without_m_h_none_and_for_touching_ends_zero() {
        let unknown = Setting::new(constants(1.0, 2.0, 1.0), 1.0, 2).expect("valid");
        assert_eq!(theorem_d_minimum_gap(unknown, n(8)), None);
        assert_eq!(theorem_d_deficit(unknown, n(8)), None);
        assert_eq!(theorem_d_polyline_gap(unknown, n(8)), None);
        assert_eq!(theorem_d_excess(unknown, n(8)), None);
        assert_eq!(theorem_d_length_excess(unknown, n(8)), None);
        let touching = setting(4.5, 32.0).with_distance(0.0).expect("a distance");
        assert_eq!(theorem_d_excess(touching, n(8)), Some(0.0));
        assert_eq!(theorem_d_deficit(touching, n(8)), Some(0.0));
        let wild = Setting::new(with_m_h(1e-300, 1.0, 1e300, 1e300), 1e4, 2).expect("valid");
        assert_eq!(theorem_d_deficit(wild, n(8)), Some(1e8));
        assert_eq!(theorem_d_excess(wild, n(8)), Some(f64::INFINITY));
        assert_eq!(theorem_d_length_excess(wild, n(8)), Some(f64::INFINITY));
    }
}
