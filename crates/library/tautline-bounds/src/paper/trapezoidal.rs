//! Theorems 1.1 and 1.2: the trapezoidal rule.
//!
//! All bounds need the setting of Theorem 1.1; `γᵖ` must be a *global* minimiser of `E_tra,N`.

use std::num::NonZeroUsize;

use crate::{Setting, c_tra_sharp_g, k3_bar_g, paper::polyline_gap::l_h_k_cubed};

/// Returns the constant `C` of Theorems 1.1 and 1.2, in `m²`.
///
/// ```text
/// C  =  C_tra♯ + L_H K̄_{3,g}³ / 4
/// ```
///
/// Overestimation: large. `C_tra♯` enters `K̄_{3,g}`, so that `C` contains `C_tra♯` to the power
/// 3/2 and with it `D⁶`. On smooth metrics the observed errors fall like `1/N²`, not like `1/√N`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[doc(alias = "theo:approx_numerical_integral_trapezoidal_length")]
#[must_use]
pub fn theorem_1_1_constant(setting: Setting) -> f64 {
    c_tra_sharp_g(setting) + l_h_k_cubed(setting.constants(), k3_bar_g(setting)) / 4.0
}

/// Bounds `E_tra,N(γᵖ) − min E`, in `m²` (Theorem 1.1, last inequality).
///
/// ```text
/// E_tra,N(γᵖ)  ≤  min E + C / N
/// ```
///
/// Overestimation: the proof yields [`c_tra_g`](crate::c_tra_g), without the second part of `C`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_minimum_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / n.get() as f64
}

/// Bounds `E(γᵖˡ) − E_tra,N(γᵖ)`, in `m²` (Theorem 1.1, second inequality). The same number bounds
/// `min E − E_tra,N(γᵖ)`, since `min E ≤ E(γᵖˡ)`.
///
/// ```text
/// E(γᵖˡ) − C / √N  ≤  E_tra,N(γᵖ)
/// ```
///
/// Overestimation: the proof yields [`polyline_gap_trapezoidal`](crate::polyline_gap_trapezoidal)
/// evaluated at `K̄_{3,g}`, without the first part of `C`. It is far smaller when it is evaluated
/// at the speed of the sequence itself.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_polyline_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / (n.get() as f64).sqrt()
}

/// Bounds `E(γᵖˡ) − min E`, in `m²` (from the proof of Theorem 1.1).
///
/// ```text
/// E(γᵖˡ) − min E  ≤  C_tra♯ / N + L_H K̄_{3,g}³ / (4 √N)  ≤  C / √N
/// ```
///
/// Adding the inequalities of the theorem gives `C/N + C/√N`. Theorem 1.2 follows from this finer
/// form, with the same `C`.
///
/// Overestimation: as for [`theorem_1_1_constant`]. The bound equals `C / √N` at `N = 1`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    let root = (n.get() as f64).sqrt();
    let cubed = l_h_k_cubed(setting.constants(), k3_bar_g(setting));
    // We divide by √N after the sum so that the second inequality also holds in `f64`.
    (c_tra_sharp_g(setting) / root + cubed / 4.0) / root
}

/// Bounds `L(γᵖˡ)² − min L²`, in `m²` (Theorem 1.2).
///
/// ```text
/// L(γᵖˡ)² − min L²  ≤  C / √N
/// ```
///
/// with the `C` of [`theorem_1_1_constant`]. A minimiser of the discrete *length* need not satisfy
/// this inequality (Section 5).
///
/// Overestimation: the proof uses `L(γᵖˡ)² ≤ E(γᵖˡ)` and bounds `E(γᵖˡ)` as [`theorem_1_1_excess`]
/// does.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal_length")]
#[must_use]
pub fn theorem_1_2_length_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / (n.get() as f64).sqrt()
}
