//! Theorems 1.3 and 1.4: the left-endpoint rule.
//!
//! All bounds need the setting of Theorem 1.1; `γᵖ` must be a *global* minimiser of `E_l,N`.

use std::num::NonZeroUsize;

use crate::{Setting, c_tra_sharp_g, k3_bar_g, k4_bar_g, paper::polyline_gap::l_h_k_cubed};

/// Returns the constant `C` of Theorems 1.3 and 1.4, in `m²`.
///
/// ```text
/// C  =  C_tra♯ + L_H K̄_{3,g}³ / 2 + L_H K̄_{4,g}³ / 2
/// ```
///
/// Overestimation: larger than for [`theorem_1_1_constant`](crate::theorem_1_1_constant). The proof
/// goes through the trapezoidal rule, and `C_tra♯` enters `K̄_{4,g}` so that its power becomes 9/4.
#[doc(alias = "theo:approx_numerical_integral_left")]
#[doc(alias = "theo:approx_numerical_integral_left_length")]
#[must_use]
pub fn theorem_1_3_constant(setting: Setting) -> f64 {
    c_tra_sharp_g(setting) + cubes(setting)
}

/// Bounds `E_l,N(γᵖ) − min E`, in `m²` (Theorem 1.3, last inequality).
///
/// ```text
/// E_l,N(γᵖ)  ≤  min E + C / √N
/// ```
///
/// Overestimation: the proof yields `C_tra♯ / N` plus [`rule_gap`](crate::rule_gap) evaluated at
/// `K̄_{3,g}`, without `K̄_{4,g}`. On a minimal geodesic the error of the left rule is only
/// `O(1/N)`.
#[doc(alias = "theo:approx_numerical_integral_left")]
#[doc(alias = "eq:left_upper_bound_revised")]
#[must_use]
pub fn theorem_1_3_minimum_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_3_constant(setting) / (n.get() as f64).sqrt()
}

/// Bounds `E(γᵖˡ) − E_l,N(γᵖ)`, in `m²` (Theorem 1.3, second inequality). The same number bounds
/// `min E − E_l,N(γᵖ)`, since `min E ≤ E(γᵖˡ)`.
///
/// ```text
/// E(γᵖˡ) − C / √N  ≤  E_l,N(γᵖ)
/// ```
///
/// Overestimation: the proof yields [`polyline_gap_left`](crate::polyline_gap_left) evaluated at
/// `K̄_{4,g}`, which is far smaller when it is evaluated at the speed of the sequence itself.
#[doc(alias = "theo:approx_numerical_integral_left")]
#[must_use]
pub fn theorem_1_3_polyline_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_3_constant(setting) / (n.get() as f64).sqrt()
}

/// Bounds `E(γᵖˡ) − min E`, in `m²` (from the proof of Theorem 1.3).
///
/// ```text
/// E(γᵖˡ) − min E  ≤  C_tra♯ / N + L_H (K̄_{3,g}³ + K̄_{4,g}³) / (2 √N)  ≤  C / √N
/// ```
///
/// Adding the inequalities of the theorem gives only `2 C/√N`. Theorem 1.4, with the same `C`,
/// follows from the finer form above.
///
/// Overestimation: as for [`theorem_1_3_constant`]. The bound equals `C / √N` at `N = 1`.
#[doc(alias = "theo:approx_numerical_integral_left")]
#[must_use]
pub fn theorem_1_3_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    let root = (n.get() as f64).sqrt();
    // We divide by √N after the sum so that the second inequality also holds in `f64`.
    (c_tra_sharp_g(setting) / root + cubes(setting)) / root
}

/// Bounds `L(γᵖˡ)² − min L²`, in `m²` (Theorem 1.4).
///
/// ```text
/// L(γᵖˡ)² − min L²  ≤  C / √N
/// ```
///
/// with the `C` of [`theorem_1_3_constant`]. A minimiser of the discrete *length* need not satisfy
/// this inequality (Section 5).
///
/// Overestimation: the proof uses `L(γᵖˡ)² ≤ E(γᵖˡ)` and bounds `E(γᵖˡ)` as [`theorem_1_3_excess`]
/// does.
#[doc(alias = "theo:approx_numerical_integral_left_length")]
#[must_use]
pub fn theorem_1_4_length_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_3_constant(setting) / (n.get() as f64).sqrt()
}

/// Returns `L_H (K̄_{3,g}³ + K̄_{4,g}³) / 2`, in `m²`.
fn cubes(setting: Setting) -> f64 {
    let constants = setting.constants();
    let (third, fourth) = (k3_bar_g(setting), k4_bar_g(setting));
    l_h_k_cubed(constants, third) / 2.0 + l_h_k_cubed(constants, fourth) / 2.0
}
