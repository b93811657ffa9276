//! The explicit constants and right-hand sides of the theorems. Each function takes constants and
//! returns a number.
//!
//! Nothing here depends on a metric, a curve or a solver. The theorems use the constants `c₁`, `c₂`
//! and `L_H` of a metric ([`Constants`]). Together with the distance `d` between the ends and the
//! dimension `D` they form a [`Setting`]; every bound is a function of a setting and of `N`.
//!
//! ```
//! use std::num::NonZeroUsize;
//! use tautline_bounds::{self as bounds, Constants, Setting};
//!
//! // A metric in the plane with I ≤ H ≤ 2 I, and ends at distance 3 from each other.
//! let setting = Setting::new(Constants::new(1.0, 2.0, 0.5)?, 3.0, 2)?;
//! assert_eq!(bounds::k1_g(setting), 3.0);
//! assert_eq!(bounds::k2_g(setting), 27.0);
//!
//! // The bound on the error of the squared length, for N = 1024 and N = 4096.
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
//! The following bounds are sharper than those of the paper. They need the same hypotheses, and
//! some also need `M_H`. The proofs are in `paper/SHARPER.md`.
//!
//! | statement | bounds | by |
//! | --- | --- | --- |
//! | Lemma S.1 | acceleration of a minimal geodesic | [`k2_sharp`] |
//! | Lemma S.2 | the energies of one sequence | [`cubic_gap`], [`cubic_rule_gap`], [`quartic_gap`] |
//! | Lemma S.3 | speeds of a stationary sequence | [`greatest_speed`], [`greatest_difference`], [`difference_step`] |
//! | Lemma S.4 | `min E_N − d²` | [`theorem_a_minimum_gap`], [`theorem_b_minimum_gap`], [`theorem_d_minimum_gap`] |
//! | Lemma S.5 | `L(γᵖˡ)²` from `E_N`, and the spread of the speeds | [`squared_length`], [`Spread`] |
//! | Theorem A | `E(γᵖˡ) − d²`, order `1/N`, by stationarity | [`theorem_a_excess`] |
//! | Theorem B | the same, order `1/N²`, trapezoidal | [`theorem_b_excess`] |
//! | Theorem C | order `1/N`, by the energy alone | [`theorem_c_excess`], [`theorem_c_length_excess`], [`theorem_c_deficit`] |
//! | Theorem D | order `1/N²`, by the energy alone | [`theorem_d_excess`], [`theorem_d_length_excess`], [`theorem_d_deficit`] |
//! | Proposition S.6 | `d²`, from one computed sequence | [`enclose`] |
//! | Proposition S.7 | the discrete minimum, from below | [`strict_convexity`] |
//! | Proposition S.8 | the region of all competitors | [`competitors`], [`competitors_within`], [`shrink`], [`reach`] |
//! | Proposition S.9 | `E(γᵖˡ) − d²` of one computed sequence, by convexity | [`convex_excess`], [`sampled_excess`] |
//! | S.10 | no bound increases with `N` | [`suggest_n`] |
//! | S.11 | `L(γᵖˡ)² − d²` by constants in the metric's own norms | [`OwnNorms`] |
//! | Propositions 7.4, 7.6, 7.11 | as there | [`velocity_error`], [`sampling_rise`], [`sampling_fall`], [`christoffel_bound`] |
//!
//! [`least_excess`] returns the least of all bounds on `E(γᵖˡ) − d²`, and [`least_length_excess`]
//! the least of all bounds on `L(γᵖˡ)² − d²`; [`suggest_n`] returns an `N` for a tolerance.
//!
//! `d²` is the minimum of both `E` and `L²`. `γᵖˡ` is the linear interpolation of a point sequence
//! `γᵖ`. In the theorems, `γᵖ` is a *global* minimiser of the discrete energy.
//!
//! # Units
//!
//! Coordinates are in `ℓ`, Riemannian length in `m`, and `t ∈ [0, 1]` is a pure number. Hence `c₁`
//! and `c₂` are in `m²/ℓ²`, `L_H` in `m²/ℓ³`, `d` in `m`, every `K` in `ℓ`, every `C` and every
//! bound on an energy in `m²`. `δ = L_H d/c₁^{3/2}` and `μ = M_H d²/c₁²` are pure numbers.
//!
//! # Rounding
//!
//! Values are computed in `f64`, rounded to nearest, with a relative error below `10⁻¹³` unless
//! they underflow. This is accurate enough to compare and plot bounds, but it certifies nothing in
//! the last digits. On overflow the result is `+∞`, and an argument may be the `+∞` of an earlier
//! overflow. If `L_H = M_H = 0` or `d = 0`, every bound on an error of a minimiser's energy is
//! exactly `0`, whatever the other inputs. No bound is NaN, and no bound on an error is negative.
//!
//! For proofs, [`enclose_outward`], [`strict_convexity_outward`], [`convex_excess_outward`] and
//! [`reach_outward`] evaluate the same formulas in intervals, with outward rounding: what they return
//! is a bound to the last digit. Where intervals overflow or decide nothing, nothing is proved: no
//! strict convexity, or an infinite reach.
//!
//! # Features
//!
//! `serde`, off by default: [`Enclosure`], [`Bound`], [`Theorem`] and [`PaperRule`] are written and
//! read by the names of their fields and variants.

mod bound_error;
#[cfg(test)]
mod by_hand;
mod number;
mod paper;
mod paper_rule;
mod product;
mod setting;
mod sharper;

pub use bound_error::BoundError;
pub use paper::*;
pub use paper_rule::PaperRule;
pub use setting::Setting;
pub use sharper::*;
pub use tautline_metrics::Constants;
