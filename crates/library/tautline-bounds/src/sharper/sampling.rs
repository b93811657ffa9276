//! Propositions 7.4 and 7.6, sharpened: the errors in velocity and energy of a sampled curve.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::{PaperRule, product::product};

/// Bounds `|βₙ − γ̇(t)|` on the `n`-th subinterval, in `ℓ`: Proposition 7.4 with its best constant.
///
/// ```text
/// |βₙ − γ̇(t)|  ≤  ((θ³ + (1 − θ)³)/3)^{1/2} ‖γ̈‖/√N,      θ = N(t − tₙ) ∈ [0, 1]
/// ```
///
/// - `theta`: the position in the subinterval. The factor is at most `1/√3`, attained at `θ = 0`
///   and `1`; in the middle it is `1/√12`. The paper has 2.
/// - `acceleration`: the `L²` norm `‖γ̈‖` on the subinterval, in `ℓ`.
///
/// Needs: `γ̇` absolutely continuous. Overestimation: the bound is attained for every `θ`; for
/// `θ = 0` by `γ = (tₙ₊₁ − t)³`.
///
/// # Panics
///
/// If `theta` is not in `[0, 1]`, or `acceleration` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral_beta-gamma")]
#[must_use]
pub fn velocity_error(acceleration: f64, theta: f64, n: NonZeroUsize) -> f64 {
    assert!((0.0..=1.0).contains(&theta), "θ must be between 0 and 1, got {theta}");
    assert!(acceleration >= 0.0, "the acceleration must be nonnegative, got {acceleration}");
    let cubes = theta.powi(3) + (1.0 - theta).powi(3);
    (cubes / (3.0 * n.get() as f64)).sqrt() * acceleration
}

/// Bounds `E_tra,N(γ) − E(γ)`, in `m²`, for a curve with `‖γ̇‖ ≤ K₁` and `‖γ̈‖ ≤ K₂`. This is the
/// upper half of Proposition 7.6.
///
/// ```text
/// E_tra,N − E  ≤  (L_H/2N) K₁² (K₁ + K₂/√3)
/// ```
///
/// `βₙ` is the mean of `γ̇` over its subinterval, so by Jensen's inequality the bound does not
/// depend on `c₂`. The midpoint of a chord is half a step away, at a speed of at most `K₁ + K₂/√3`.
///
/// Needs: `H ≥ 0`, `H` Lipschitz with `L_H`, and `γ̇` absolutely continuous.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral")]
#[must_use]
pub fn sampling_rise(constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
    assert!(k1 >= 0.0 && k2 >= 0.0, "K1 and K2 must be nonnegative, got {k1} and {k2}");
    let speed = k1 + k2 / 3_f64.sqrt();
    product([0.5, constants.l_h(), k1, k1, speed]) / n.get() as f64
}

/// Bounds `E(γ) − E_tra,N(γ)`, in `m²`, for a curve with `‖γ̇‖ ≤ K₁` and `‖γ̈‖ ≤ K₂`. This is the
/// lower half of Proposition 7.6.
///
/// ```text
/// E − E_tra,N  ≤  (L_H/2N) K₁² (K₁ + K₂/√3) + c₂ K₂²/π²N²
/// ```
///
/// The cross term of the paper's proof integrates to 0; the last term follows from Wirtinger's
/// inequality.
///
/// Needs: `0 ≤ H ≤ c₂`, `H` Lipschitz with `L_H`, and `γ̇` absolutely continuous. Overestimation:
/// the bound is attained by a constant metric and a cosine.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "prop:approx_numerical_integral")]
#[must_use]
pub fn sampling_fall(constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
    let wirtinger = std::f64::consts::PI * n.get() as f64;
    sampling_rise(constants, k1, k2, n)
        + product([constants.c2(), k2, k2]) / (wirtinger * wirtinger)
}

/// Bounds `E_N(γ) − E(γ)`, in `m²`, for a curve with `|γ̇| ≤ A₁` and `|γ̈| ≤ A₂` at every time.
///
/// ```text
/// E_tra,N − E  ≤  L_H A₁² (A₁/4N + A₂/12N²),      E_l,N − E  ≤  L_H A₁³/2N
/// ```
///
/// Needs: as for [`sampling_rise`]; the left-endpoint rule does not need `γ̈`. Overestimation: the
/// first terms are attained by a straight line, over a tent at the middle of each chord
/// (trapezoidal) and down a slope (left endpoint).
///
/// # Panics
///
/// If `a1` or `a2` is negative or NaN.
#[must_use]
pub fn pointwise_rise(
    constants: Constants,
    rule: PaperRule,
    a1: f64,
    a2: f64,
    n: NonZeroUsize,
) -> f64 {
    assert!(a1 >= 0.0 && a2 >= 0.0, "A1 and A2 must be nonnegative, got {a1} and {a2}");
    let count = n.get() as f64;
    let away = match rule {
        PaperRule::Trapezoidal => a1 / (4.0 * count) + a2 / (12.0 * count * count),
        PaperRule::LeftEndpoint => a1 / (2.0 * count),
    };
    product([constants.l_h(), a1, a1, away])
}

/// Bounds `E(γ) − E_tra,N(γ)`, in `m²`, for a curve with `|γ̇| ≤ A₁` and `|γ̈| ≤ A₂` at every time.
///
/// ```text
/// E − E_tra,N  ≤  L_H A₁² (A₁/4N + A₂/12N²) + c₂ A₂²/12N²
/// ```
///
/// Needs: as for [`sampling_fall`].
///
/// # Panics
///
/// If `a1` or `a2` is negative or NaN.
#[must_use]
pub fn pointwise_fall(constants: Constants, a1: f64, a2: f64, n: NonZeroUsize) -> f64 {
    let count = n.get() as f64;
    pointwise_rise(constants, PaperRule::Trapezoidal, a1, a2, n)
        + product([constants.c2(), a2, a2]) / (12.0 * count * count)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{pointwise_fall, pointwise_rise, sampling_fall, sampling_rise, velocity_error};
    use crate::{
        PaperRule,
        by_hand::{close, constants, n},
    };

    #[test]
    fn by_hand() {
        let (constants, five, root) = (constants(1.0, 9.0, 4.0), n(5), 3_f64.sqrt());
        let risen = 0.4 * 9.0 * (3.0 + 2.0 / root);
        let risen_pointwise = 36.0 * (3.0 / 20.0 + 2.0 / 300.0);
        let pointwise = |rule| pointwise_rise(constants, rule, 3.0, 2.0, five);
        for (value, expected) in [
            (velocity_error(6.0, 0.0, five), 6.0 / 15_f64.sqrt()),
            (velocity_error(6.0, 1.0, five), 6.0 / 15_f64.sqrt()),
            (velocity_error(6.0, 0.5, five), 6.0 / 60_f64.sqrt()),
            (sampling_rise(constants, 3.0, 2.0, five), risen),
            (sampling_fall(constants, 3.0, 2.0, five), risen + 36.0 / (25.0 * PI * PI)),
            (pointwise(PaperRule::Trapezoidal), risen_pointwise),
            (pointwise(PaperRule::LeftEndpoint), 36.0 * 0.3),
            (pointwise_fall(constants, 3.0, 2.0, five), risen_pointwise + 36.0 / 300.0),
        ] {
            // This allows for about ten roundings.
            close(value, expected, 2e-15);
        }
    }
}
