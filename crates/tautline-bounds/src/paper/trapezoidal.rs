//! Theorems 1.1 and 1.2: the trapezoidal rule.

use std::num::NonZeroUsize;

use crate::{Setting, c_tra_sharp_g, k3_bar_g, paper::polyline_gap::l_h_k_cubed};

/// Returns the constant `C` of Theorem 1.1, which is that of Theorem 1.2 too, in `m²`.
///
/// ```text
/// C  =  C_tra♯ + L_H K̄_{3,g}³ / 4
/// ```
///
/// Needs: the setting of Theorem 1.1.
///
/// Overestimation: large. `C_tra♯` enters to the power 3/2 through `K̄_{3,g}`, and with it `D⁶`; on
/// smooth metrics the observed errors fall like `1/N²`, not like `1/√N`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[doc(alias = "theo:approx_numerical_integral_trapezoidal_length")]
#[must_use]
pub fn theorem_1_1_constant(setting: Setting) -> f64 {
    c_tra_sharp_g(setting) + l_h_k_cubed(setting.constants(), k3_bar_g(setting)) / 4.0
}

/// Bounds `E_tra,N(γᵖ) − min E` for the minimiser `γᵖ` of `E_tra,N`, in `m²` (Theorem 1.1, the
/// last inequality).
///
/// ```text
/// E_tra,N(γᵖ)  ≤  min E + C / N
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser.
///
/// Overestimation: the proof has [`c_tra_g`](crate::c_tra_g) in its place; the second part of `C`
/// is not needed here.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_minimum_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / n.get() as f64
}

/// Bounds `E(γᵖˡ) − E_tra,N(γᵖ)` for the minimiser `γᵖ` of `E_tra,N`, in `m²` (Theorem 1.1, the
/// second inequality); hence also `min E − E_tra,N(γᵖ)`, since `min E ≤ E(γᵖˡ)`.
///
/// ```text
/// E(γᵖˡ) − C / √N  ≤  E_tra,N(γᵖ)
/// ```
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser.
///
/// Overestimation: the proof has [`polyline_gap_trapezoidal`](crate::polyline_gap_trapezoidal) at
/// `K̄_{3,g}` in its place; the first part of `C` is not needed here. With the speed of the
/// sequence itself in place of `K̄_{3,g}` that bound is far smaller.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_polyline_gap(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / (n.get() as f64).sqrt()
}

/// Bounds `E(γᵖˡ) − min E` for the minimiser `γᵖ` of `E_tra,N`, in `m²` (from the proof of
/// Theorem 1.1, before `C` is named).
///
/// ```text
/// E(γᵖˡ) − min E  ≤  C_tra♯ / N + L_H K̄_{3,g}³ / (4 √N)  ≤  C / √N
/// ```
///
/// The theorem's own inequalities, added, give `C/N + C/√N` here. Theorem 1.2 rests on this
/// finer form: it has the same `C`, not twice as much.
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser.
///
/// Overestimation: that of [`theorem_1_1_constant`]. Equal to `C / √N` at `N = 1`.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    let root = (n.get() as f64).sqrt();
    let cubed = l_h_k_cubed(setting.constants(), k3_bar_g(setting));
    // One division by √N after the sum: then the second inequality holds in `f64` too.
    (c_tra_sharp_g(setting) / root + cubed / 4.0) / root
}

/// Bounds `L(γᵖˡ)² − min L²` for the minimiser `γᵖ` of `E_tra,N`, in `m²` (Theorem 1.2).
///
/// ```text
/// L(γᵖˡ)² − min L²  ≤  C / √N
/// ```
///
/// with the `C` of [`theorem_1_1_constant`].
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser of the discrete energy (a
/// minimiser of the discrete length will not do: Section 5).
///
/// Overestimation: `L(γᵖˡ)²` is at most `E(γᵖˡ)`, and [`theorem_1_1_excess`] bounds that.
#[doc(alias = "theo:approx_numerical_integral_trapezoidal_length")]
#[must_use]
pub fn theorem_1_2_length_excess(setting: Setting, n: NonZeroUsize) -> f64 {
    theorem_1_1_constant(setting) / (n.get() as f64).sqrt()
}
