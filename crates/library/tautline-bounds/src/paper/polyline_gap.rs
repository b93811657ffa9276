//! Propositions 7.9, 8.1 and 8.2: bounds on the differences between the energies of a point
//! sequence.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::product::product;

/// Bounds `|E(γᵖˡ) − E_tra,N(γᵖ)|`, in `m²` (Proposition 7.9).
///
/// ```text
/// |E(γᵖˡ) − E_tra,N(γᵖ)|  ≤  L_H K₃³ / (4 √N),     K₃² = (1/N) Σ ‖β(tₙ)‖²
/// ```
///
/// - `constants`: the constants of `g`; only `L_H` (`m²/ℓ³`) is used.
/// - `k3`: the root mean square speed `K₃` of the point sequence, in `ℓ`, or an upper bound on it.
/// - `n`: the number of subintervals `N`; the sequence has `N + 1` points.
///
/// Needs: `H` Lipschitz on the segments of `γᵖˡ`. The bound needs neither `c₁` nor `c₂`, and `γᵖ`
/// need not be a minimiser.
///
/// Overestimation: the proof replaces `Σ ‖β‖³` by `(Σ ‖β‖²)^{3/2}`, which loses a factor `√N` when
/// the speeds are equal. The bound is attained for every `N` by a sequence that moves in one step
/// only, if `H` has a ridge or a valley at the middle of that step.
///
/// # Panics
///
/// If `k3` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral_pts")]
#[must_use]
pub fn polyline_gap_trapezoidal(constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
    l_h_k_cubed(constants, k3) / (4.0 * (n.get() as f64).sqrt())
}

/// Bounds `|E(γᵖˡ) − E_l,N(γᵖ)|`, in `m²` (Proposition 8.2).
///
/// ```text
/// |E(γᵖˡ) − E_l,N(γᵖ)|  ≤  L_H K₃³ / (2 √N)
/// ```
///
/// Arguments and needs: as for [`polyline_gap_trapezoidal`]. This bound is twice as large, since
/// the points of a chord are on average twice as far from its left endpoint as from its midpoint.
///
/// Overestimation: as for [`polyline_gap_trapezoidal`], but the bound is attained if `H` is linear
/// along the single step.
///
/// # Panics
///
/// If `k3` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral_pts_left")]
#[must_use]
pub fn polyline_gap_left(constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
    l_h_k_cubed(constants, k3) / (2.0 * (n.get() as f64).sqrt())
}

/// Bounds `|E_l,N(γᵖ) − E_tra,N(γᵖ)|`, in `m²` (Proposition 8.1).
///
/// ```text
/// |E_l,N(γᵖ) − E_tra,N(γᵖ)|  ≤  L_H K₃³ / (2 √N)
/// ```
///
/// Arguments and needs: as for [`polyline_gap_trapezoidal`], but `H` need only be Lipschitz from
/// the left endpoint of each chord to its midpoint.
///
/// Overestimation: as for [`polyline_gap_trapezoidal`], but the bound is attained if `H` is linear
/// along the single step.
///
/// # Panics
///
/// If `k3` is negative or NaN.
#[doc(alias = "prop:left_trapezoidal_fomula")]
#[must_use]
pub fn rule_gap(constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
    l_h_k_cubed(constants, k3) / (2.0 * (n.get() as f64).sqrt())
}

/// Returns `L_H K³`, in `m²`.
pub(crate) fn l_h_k_cubed(constants: Constants, k: f64) -> f64 {
    assert!(k >= 0.0, "K3 must be nonnegative, got {k}");
    product([constants.l_h(), k, k, k])
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroUsize;

    use super::{polyline_gap_left, polyline_gap_trapezoidal, rule_gap};
    use crate::{
        Constants,
        by_hand::{constants, n},
    };

    /// Takes one step from 0 to 1 and then rests, so that `K₃² = N² / N`. Every `N` here is a power
    /// of 4 and the other numbers are dyadic, so the comparisons are exact.
    fn one_step(check: impl Fn(Constants, f64, NonZeroUsize)) {
        for power in 0..8 {
            check(constants(1.0, 6.0, 5.0), 2_f64.powi(power as i32), n(4_usize.pow(power)));
        }
    }

    #[test]
    fn prop_7_9_is_attained_by_one_step_over_a_ridge() {
        one_step(|constants, k3, n| {
            // H = 6 − 5 |x − ½|: the rule gives N H(½), and the curve N ∫₀¹ H = N (6 − 5/4).
            let gap = n.get() as f64 * (6.0 - (6.0 - 1.25));
            assert_eq!(polyline_gap_trapezoidal(constants, k3, n), gap);
        });
    }

    #[test]
    fn prop_8_1_and_8_2_are_attained_by_one_step_up_a_slope() {
        one_step(|constants, k3, n| {
            // H = 1 + 5 x: the left rule gives N H(0). The trapezoidal rule gives N H(½), and the
            // curve N ∫₀¹ H, which is the same number.
            let gap = n.get() as f64 * (3.5 - 1.0);
            assert_eq!(rule_gap(constants, k3, n), gap);
            assert_eq!(polyline_gap_left(constants, k3, n), gap);
        });
    }

    #[test]
    fn an_infinite_argument_gives_no_nan() {
        let (flat, bent) = (constants(1.0, 6.0, 0.0), constants(1.0, 6.0, 5.0));
        for gap in [polyline_gap_trapezoidal, polyline_gap_left, rule_gap] {
            assert_eq!(gap(flat, f64::INFINITY, NonZeroUsize::MIN), 0.0);
            assert_eq!(gap(bent, f64::INFINITY, NonZeroUsize::MAX), f64::INFINITY);
            assert_eq!(gap(bent, 1e200, NonZeroUsize::MIN), f64::INFINITY);
            assert_eq!(gap(bent, 0.0, NonZeroUsize::MIN), 0.0);
        }
    }
}
