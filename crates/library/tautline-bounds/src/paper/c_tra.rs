//! `C_tra(N)` and `C_tra♯`: bounds on the error of the trapezoidal rule for the energy of a curve.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::{Setting, k1_g, k2_g, product::product};

/// Bounds `|E(γ) − E_tra,N(γ)|` for curves with `‖γ̇‖_{L²} ≤ K₁` and `‖γ̈‖_{L²} ≤ K₂`, in `m²`
/// (Proposition 7.6). The same number therefore bounds `inf E_tra,N − inf E` over any set of such
/// curves (Proposition 7.7).
///
/// ```text
/// C_tra(N)  =  (L_H (K₁³ + 2 K₁² K₂) + 4 c₂ K₁ K₂) / N  +  4 c₂ K₂² / N²
/// ```
///
/// - `constants`: the constants of `g`; only `c₂` (`m²/ℓ²`) and `L_H` (`m²/ℓ³`) are used.
/// - `k1`, `k2`: bounds on the speed and on the acceleration, in `ℓ`.
/// - `n`: the number of subintervals `N`.
///
/// Needs: `0 ≤ H ≤ c₂`, `H` Lipschitz, and `γ̇` absolutely continuous with `γ̈` in `L²`. A kink is
/// not allowed even if `γ̈` vanishes on both sides of it: for `γ(t) = |t − ½|` with `H = 1` and
/// `N = 1`, `E = 1` and `E_tra = 0`, but the bound is 0.
///
/// Overestimation: `β` is the mean of `γ̇` over its subinterval, so the cross term `4 c₂ K₁ K₂ / N`
/// of the proof integrates to 0, and the last term could be `c₂ K₂² / (π N)²`. The first term could
/// be halved, since the midpoint of the chord is half a step away and not a whole one.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral")]
#[doc(alias = "prop:approx_numerical_integral_set")]
#[must_use]
pub fn c_tra(constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
    let (first, second) = coefficients(constants, k1, k2);
    let n = n.get() as f64;
    // We divide by N after the sum so that C_tra(N) ≤ C_tra♯ / N also holds in `f64`.
    (first + second / n) / n
}

/// Returns `C_tra♯`, in `m²`, for which `C_tra(N) ≤ C_tra♯ / N` (Section 7, before Proposition
/// 7.7).
///
/// ```text
/// C_tra♯  =  L_H (K₁³ + 2 K₁² K₂) + 4 c₂ K₁ K₂ + 4 c₂ K₂²
/// ```
///
/// Arguments and needs: as for [`c_tra`].
///
/// Overestimation: the inequality is attained at `N = 1`, where `C_tra♯ = C_tra(1)`. For larger `N`
/// the last term of `C_tra(N)` falls like `1/N²`, but that of `C_tra♯ / N` only like `1/N`.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "C_tra^sharp")]
#[must_use]
pub fn c_tra_sharp(constants: Constants, k1: f64, k2: f64) -> f64 {
    c_tra(constants, k1, k2, NonZeroUsize::MIN)
}

/// Bounds `min E_tra,N − min E` between the ends of a setting, in `m²`, by [`c_tra`] evaluated at
/// `K_{1,g}` and `K_{2,g}` (Section 7, proof of Theorem 1.1).
///
/// The bound is one-sided: it does not limit how far `min E_tra,N` can fall below `min E`.
///
/// Needs: the setting of Theorem 1.1. Overestimation: as for [`c_tra`] and [`k2_g`].
#[doc(alias = "eq:approx_numerical_integral_lower_bound_revised")]
#[must_use]
pub fn c_tra_g(setting: Setting, n: NonZeroUsize) -> f64 {
    c_tra(setting.constants(), k1_g(setting), k2_g(setting), n)
}

/// Returns the `C_tra♯` of a setting, in `m²`: [`c_tra_sharp`] evaluated at `K_{1,g}` and
/// `K_{2,g}`. It satisfies `min E_tra,N − min E ≤ C_tra♯ / N` (Section 7, proof of Theorem 1.1).
///
/// With `δ = L_H d / c₁^{3/2}` and `κ = c₂ / c₁`, it is
///
/// ```text
/// C_tra♯  =  d² (δ + 3 D² δ² + 6 κ D² δ + 9 κ D⁴ δ²)
/// ```
///
/// Needs: the setting of Theorem 1.1. Overestimation: as for [`c_tra_g`] and [`c_tra_sharp`].
#[doc(alias = "C_tra^sharp")]
#[must_use]
pub fn c_tra_sharp_g(setting: Setting) -> f64 {
    c_tra_sharp(setting.constants(), k1_g(setting), k2_g(setting))
}

/// Returns the coefficients of `1/N` and of `1/N²` in `C_tra(N)`, in `m²`.
fn coefficients(constants: Constants, k1: f64, k2: f64) -> (f64, f64) {
    assert!(k1 >= 0.0, "K1 must be nonnegative, got {k1}");
    assert!(k2 >= 0.0, "K2 must be nonnegative, got {k2}");
    let (c2, l_h) = (constants.c2(), constants.l_h());
    let first =
        product([l_h, k1, k1, k1]) + product([2.0, l_h, k1, k1, k2]) + product([4.0, c2, k1, k2]);
    (first, product([4.0, c2, k2, k2]))
}

#[cfg(test)]
mod tests {
    use super::{c_tra, c_tra_sharp};
    use crate::by_hand::{close, constants, n};

    #[test]
    fn by_hand() {
        // L_H = 7, c₂ = 5, K₁ = 2, K₂ = 3: 7 (8 + 2·4·3) + 4·5·2·3 = 344 and 4·5·9 = 180. These are
        // integers, so the results are exact up to N = 4; at N = 10 two divisions and a sum round,
        // by 2⁻⁵³ each.
        let constants = constants(1.0, 5.0, 7.0);
        assert_eq!(c_tra_sharp(constants, 2.0, 3.0), 524.0);
        assert_eq!(c_tra(constants, 2.0, 3.0, n(1)), 524.0);
        assert_eq!(c_tra(constants, 2.0, 3.0, n(2)), 217.0);
        assert_eq!(c_tra(constants, 2.0, 3.0, n(4)), 97.25);
        close(c_tra(constants, 2.0, 3.0, n(10)), 36.2, 1e-15);
    }

    #[test]
    fn c1_does_not_enter() {
        let at = |c1| c_tra(constants(c1, 5.0, 7.0), 2.0, 3.0, n(3));
        assert_eq!(at(0.1), at(5.0));
    }

    #[test]
    fn an_infinite_argument_gives_no_nan() {
        let (flat, bent) = (constants(1.0, 5.0, 0.0), constants(1.0, 5.0, 7.0));
        assert_eq!(c_tra(flat, f64::INFINITY, 0.0, n(2)), 0.0);
        assert_eq!(c_tra(bent, f64::INFINITY, 0.0, n(2)), f64::INFINITY);
        assert_eq!(c_tra(bent, 1e200, 1e200, n(2)), f64::INFINITY);
    }
}
