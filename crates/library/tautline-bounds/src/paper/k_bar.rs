//! `K̄_{3,g}` and `K̄_{4,g}`: bounds on the speed of discrete minimisers, uniform in `N`.

use crate::{Setting, c_tra_sharp_g, k1_g, paper::polyline_gap::l_h_k_cubed};

/// Bounds the root mean square speed `K₃` of every minimiser of `E_tra,N`, for every `N`, in `ℓ`
/// (Section 7, proof of Theorem 1.1).
///
/// ```text
/// K̄_{3,g}²  =  (d² + C_tra♯) / c₁  =  K_{1,g}² + C_tra♯ / c₁
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser (or any admissible sequence with
/// `E_tra,N ≤ d² + C_tra♯`).
///
/// Overestimation: up to a factor `√(1 + C_tra♯ / d²)` for large `N`, since `C_tra♯` replaces
/// `C_tra(N)`, which tends to 0.
#[doc(alias = "overline K_{3,g}")]
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn k3_bar_g(setting: Setting) -> f64 {
    k1_g(setting).hypot(c_tra_sharp_g(setting).sqrt() / setting.constants().c1().sqrt())
}

/// Bounds the root mean square speed `K₃` of every minimiser of `E_l,N`, for every `N`, in `ℓ`
/// (Section 8, proof of Theorem 1.3).
///
/// ```text
/// K̄_{4,g}²  =  (d² + C_tra♯ + ½ L_H K̄_{3,g}³) / c₁  =  K̄_{3,g}² + L_H K̄_{3,g}³ / (2 c₁)
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser (or any admissible sequence with
/// `E_l,N ≤ d² + C_tra♯ + ½ L_H K̄_{3,g}³`).
///
/// Overestimation: as for [`k3_bar_g`]. In addition, the minimum of `E_l,N` is bounded by its value
/// at the minimiser of `E_tra,N`, whose speed is bounded by `K̄_{3,g}`.
#[doc(alias = "overline K_{4,g}")]
#[doc(alias = "theo:approx_numerical_integral_left")]
#[must_use]
pub fn k4_bar_g(setting: Setting) -> f64 {
    let (constants, k3) = (setting.constants(), k3_bar_g(setting));
    k3.hypot((l_h_k_cubed(constants, k3) / 2.0).sqrt() / constants.c1().sqrt())
}
