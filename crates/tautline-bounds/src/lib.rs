//! The explicit constants and right sides of the theorems: constants in, constants out.
//!
//! Nothing here sees a metric, a curve or a solver. What the theorems know of a metric are
//! `c₁`, `c₂` and `L_H` ([`Constants`]); with the distance `d` of the ends and the dimension
//! `D` they make a [`Setting`], and every bound is a function of that and of `N`.
//!
//! ```
//! use std::num::NonZeroUsize;
//! use tautline_bounds::{self as bounds, Constants, Setting};
//!
//! // A metric in the plane whose Gram matrix lies between I and 2 I, and ends 3 apart.
//! let setting = Setting::new(Constants::new(1.0, 2.0, 0.5)?, 3.0, 2)?;
//! assert_eq!(bounds::k1_g(setting), 3.0);
//! assert_eq!(bounds::k2_g(setting), 27.0);
//!
//! // How far the length of the reconstruction can be off at N = 1024, and at four times that.
//! let at = |n| bounds::theorem_1_2_length_excess(setting, NonZeroUsize::new(n).unwrap());
//! assert!(at(1024) > 0.0);
//! assert_eq!(at(4096), at(1024) / 2.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Statement by statement
//!
//! | statement | bounds | by |
//! | --- | --- | --- |
//! | Proposition 7.6 | `abs(E − E_tra,N)` of one curve | [`c_tra`] |
//! | Proposition 7.7 | `inf E_tra,N − inf E` | [`c_tra`], [`c_tra_sharp`] `/ N` |
//! | Proposition 7.9 | `abs(E(γᵖˡ) − E_tra,N)` of a point sequence | [`polyline_gap_trapezoidal`] |
//! | Proposition 7.12 | speed and acceleration of a minimal geodesic | [`k1_g`], [`k2_g`] |
//! | Section 7, proof of Theorem 1.1 | `min E_tra,N − min E` | [`c_tra_g`], [`c_tra_sharp_g`] `/ N` |
//! | | speed of the trapezoidal minimiser | [`k3_bar_g`] |
//! | Theorem 1.1 | `min E_tra,N − min E` | [`theorem_1_1_minimum_gap`] |
//! | | `E(γᵖˡ) − min E_tra,N` and `min E − min E_tra,N` | [`theorem_1_1_polyline_gap`] |
//! | | `E(γᵖˡ) − min E`, from its proof | [`theorem_1_1_excess`] |
//! | | its constant `C` | [`theorem_1_1_constant`] |
//! | Theorem 1.2 | `L(γᵖˡ)² − min L²` | [`theorem_1_2_length_excess`] |
//! | Proposition 8.1 | `abs(E_l,N − E_tra,N)` of a point sequence | [`rule_gap`] |
//! | Proposition 8.2 | `abs(E(γᵖˡ) − E_l,N)` of a point sequence | [`polyline_gap_left`] |
//! | Section 8, proof of Theorem 1.3 | speed of the left-endpoint minimiser | [`k4_bar_g`] |
//! | Theorem 1.3 | `min E_l,N − min E` | [`theorem_1_3_minimum_gap`] |
//! | | `E(γᵖˡ) − min E_l,N` and `min E − min E_l,N` | [`theorem_1_3_polyline_gap`] |
//! | | `E(γᵖˡ) − min E`, from its proof | [`theorem_1_3_excess`] |
//! | | its constant `C` | [`theorem_1_3_constant`] |
//! | Theorem 1.4 | `L(γᵖˡ)² − min L²` | [`theorem_1_4_length_excess`] |
//!
//! Sharper than the paper, with the same hypotheses, `1/N` in place of `1/√N`:
//!
//! | bounds | trapezoidal | left endpoint |
//! | --- | --- | --- |
//! | `min E_N − min E` | [`first_order_minimum_gap_trapezoidal`] | [`first_order_minimum_gap_left`] |
//! | `E(γᵖˡ) − min E_N` and `min E − min E_N` | [`first_order_polyline_gap_trapezoidal`] | [`first_order_polyline_gap_left`] |
//! | `E(γᵖˡ) − min E` and `L(γᵖˡ)² − min L²` | [`first_order_excess_trapezoidal`] | [`first_order_excess_left`] |
//!
//! The minimum of `E` is `d²`, and that of `L²` too. `γᵖˡ` is the linear interpolation of a
//! point sequence; in the theorems, of a *global* minimiser of the discrete energy.
//!
//! # Units
//!
//! Coordinates are in `ℓ`, Riemannian length in `m`, and `t ∈ [0, 1]` is a pure number. Hence
//! `c₁` and `c₂` are in `m²/ℓ²`, `L_H` in `m²/ℓ³`, `d` in `m`; every `K` is in `ℓ`, and every
//! `C` and every bound of an energy in `m²`.
//!
//! # Rounding
//!
//! Values are computed in `f64` and rounded to nearest, to a relative error below `10⁻¹³` short
//! of underflow: good for comparing and drawing, not a certificate in the last digits. What
//! exceeds the range of `f64` is `+∞`. Where `L_H = 0`, every bound of an energy is the exact
//! `0`, and where `d = 0` every bound is, however large the rest. No function returns NaN or a
//! negative number.

mod apriori;
mod c_tra;
mod first_order;
mod k_bar;
mod left_endpoint;
mod polyline_gap;
mod product;
mod setting;
mod trapezoidal;

pub use apriori::{k1_g, k2_g};
pub use c_tra::{c_tra, c_tra_g, c_tra_sharp, c_tra_sharp_g};
pub use first_order::{
    first_order_excess_left, first_order_excess_trapezoidal, first_order_minimum_gap_left,
    first_order_minimum_gap_trapezoidal, first_order_polyline_gap_left,
    first_order_polyline_gap_trapezoidal,
};
pub use k_bar::{k3_bar_g, k4_bar_g};
pub use left_endpoint::{
    theorem_1_3_constant, theorem_1_3_excess, theorem_1_3_minimum_gap, theorem_1_3_polyline_gap,
    theorem_1_4_length_excess,
};
pub use polyline_gap::{polyline_gap_left, polyline_gap_trapezoidal, rule_gap};
pub use setting::{BoundError, Setting};
pub use tautline_metrics::Constants;
pub use trapezoidal::{
    theorem_1_1_constant, theorem_1_1_excess, theorem_1_1_minimum_gap, theorem_1_1_polyline_gap,
    theorem_1_2_length_excess,
};
