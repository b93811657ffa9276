//! Lemma S.2: bounds on the differences between the energies of a point sequence, in terms of the
//! moments of its speeds.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::{PaperRule, product::product};

/// Bounds `|E(γᵖˡ) − E_N(γᵖ)|` for a rule of the paper, in `m²` (Lemma S.2).
///
/// ```text
/// |E(γᵖˡ) − E_N(γᵖ)|  ≤  (k L_H/N) mean |β|³,      k = ¼ (trapezoidal), ½ (left endpoint)
/// ```
///
/// On a chord, `H` differs from its value at the node by at most `L_H` times the distance from the
/// node, and the mean of this distance is `kh|β|`. Propositions 7.9 and 8.2 further estimate
/// `mean |β|³ ≤ √N K₃³`.
///
/// - `mean_cube`: `(1/N) Σ |βₙ|³`, in `ℓ³`, or an upper bound on it.
///
/// Needs: `H` Lipschitz along the chords. Neither `c₁` nor `c₂` nor a minimiser is needed.
/// Overestimation: the bound is attained by a valley at the middle of each chord (trapezoidal) and
/// by `H` linear along each chord (left endpoint).
///
/// # Panics
///
/// If `mean_cube` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral_pts")]
#[doc(alias = "prop:approx_numerical_integral_pts_left")]
#[must_use]
pub fn cubic_gap(constants: Constants, rule: PaperRule, mean_cube: f64, n: NonZeroUsize) -> f64 {
    assert!(mean_cube >= 0.0, "the mean cube must be nonnegative, got {mean_cube}");
    product([rule.mean_distance(), constants.l_h(), mean_cube]) / n.get() as f64
}

/// Bounds `|E_l,N(γᵖ) − E_tra,N(γᵖ)|`, in `m²`, by `(L_H/2N) mean |β|³` (Lemma S.2).
///
/// Arguments, needs and overestimation: as for [`cubic_gap`]. The nodes of the two rules are half a
/// chord apart.
///
/// # Panics
///
/// If `mean_cube` is negative or NaN.
#[doc(alias = "prop:left_trapezoidal_fomula")]
#[must_use]
pub fn cubic_rule_gap(constants: Constants, mean_cube: f64, n: NonZeroUsize) -> f64 {
    cubic_gap(constants, PaperRule::LeftEndpoint, mean_cube, n)
}

/// Bounds `|E(γᵖˡ) − E_tra,N(γᵖ)|`, in `m²` (Lemma S.2). Returns `None` if `M_H` is unknown.
///
/// ```text
/// |E(γᵖˡ) − E_tra,N(γᵖ)|  ≤  (M_H/24N²) mean |β|⁴
/// ```
///
/// The linear part of `H` about the middle of a chord is odd, so its mean vanishes.
///
/// - `mean_fourth`: `(1/N) Σ |βₙ|⁴`, in `ℓ⁴`, or an upper bound on it.
///
/// Needs: `DH` Lipschitz along the chords. Overestimation: the bound is attained if `H` is
/// quadratic along each chord.
///
/// # Panics
///
/// If `mean_fourth` is negative or NaN.
#[must_use]
pub fn quartic_gap(constants: Constants, mean_fourth: f64, n: NonZeroUsize) -> Option<f64> {
    assert!(mean_fourth >= 0.0, "the mean fourth power must be nonnegative, got {mean_fourth}");
    let n = n.get() as f64;
    constants.m_h().map(|m_h| product([m_h, mean_fourth]) / (24.0 * n * n))
}

#[cfg(test)]
mod tests {
    use super::{cubic_gap, cubic_rule_gap, quartic_gap};
    use crate::{
        PaperRule,
        by_hand::{constants, n},
    };

    /// The first chord has length 4 and lies over `H = 1 + 3|x − 2|`, `1 + 3x` or `1 + 3(x − 2)²`;
    /// the second has length 0. So `β` is 8 and 0, `mean |β|³ = 256` and `mean |β|⁴ = 2048`.
    #[test]
    fn attained_by_a_valley_a_slope_and_a_parabola() {
        let (constants, two) = (constants(1.0, 13.0, 3.0), n(2));
        // ½·64 (mean H − H(node)); the mean of |x − 2| is 1, that of x is 2, and that of (x − 2)²
        // is 4/3.
        let trapezoidal = cubic_gap(constants, PaperRule::Trapezoidal, 256.0, two);
        assert_eq!(trapezoidal, 32.0 * 3.0);
        assert_eq!(cubic_gap(constants, PaperRule::LeftEndpoint, 256.0, two), 32.0 * 6.0);
        assert_eq!(cubic_rule_gap(constants, 256.0, two), 32.0 * 6.0);
        assert_eq!(quartic_gap(constants, 2048.0, two), None);
        // D²H = 6.
        let smooth = constants.with_m_h(6.0).expect("nonnegative");
        assert_eq!(quartic_gap(smooth, 2048.0, two), Some(32.0 * 4.0));
    }
}
