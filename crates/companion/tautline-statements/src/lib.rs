//! Every statement of the paper as a function that returns its evidence.
//!
//! Each function evaluates its statement on a case. The [`Evidence`] contains the hypotheses,
//! checked or assumed, and the inequalities, each with the observed number and the bound.
//!
//! ```
//! use tautline::{PointSequence, gallery::Valleys};
//! use tautline_statements::{Finding, LIBRARY, prop_7_9};
//!
//! // |E(γᵖˡ) − E_tra,N| ≤ L_H K₃³ / 4√N for four points over a ridge
//! let sequence = PointSequence::straight([0.0, 0.0], [6.0, 1.0], 3)?;
//! let evidence = prop_7_9(&LIBRARY, &Valleys, &sequence)?;
//! assert_eq!(evidence.finding(), Finding::Holds);
//! assert!(evidence.overestimation() > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | section | takes | functions |
//! | --- | --- | --- |
//! | 1, main results | a [`Reconstruction`] | [`theorem_1_1`] to [`theorem_1_4`] |
//! | 3, geodesics and distances | a curve, or two points | [`prop_3_1`], [`prop_3_2`], [`prop_3_3`] |
//! | 4, minimal curves | a geodesic and a clock, a tangent vector, or a curve | [`prop_4_1`], [`prop_4_2`], [`prop_4_3`], [`lemma_4_4`] |
//! | 5, the counterexample | a point sequence over the valleys | [`section_5_left`], [`section_5_trapezoidal`] |
//! | 6, energy and length | a curve between points or sets | [`prop_6_1`], [`prop_6_2`], [`prop_6_3`] |
//! | 7, existence | two sets and two point sequences | [`prop_7_1`], and [`critical_point`] of a minimiser |
//! | 7, curves | a [`BoundedCurve`](curves::BoundedCurve) | [`prop_7_2`] to [`prop_7_4`] |
//! | 7, matrices | [`TwoForms`] | [`prop_7_5`] |
//! | 7, sampled curves | a metric, curves and `N` | [`prop_7_6`], [`prop_7_7`] |
//! | | constants, `K₁`, `K₂` and `N` | [`constant_c_tra`], [`constant_c_tra_sharp`] |
//! | 7, derivatives | a metric and a point | [`prop_7_10`], [`prop_7_11`] |
//! | 7, a priori | a metric and a minimal geodesic | [`constant_k1`], [`constant_k2`], [`prop_7_12`] |
//! | 7 and 8, any point sequence | a metric and a point sequence | [`prop_7_8`], [`prop_7_9`], [`prop_8_1`], [`prop_8_2`] |
//! | 7 and 8, constants of the theorems | a [`Reconstruction`] | [`constant_k3_bar`], [`constant_c_1_1`], [`constant_k4_bar`], [`constant_c_1_3`] |
//! | sharper | as the statement needs | [`lemma_s_1`] to [`lemma_s_5`], [`theorem_a`] to [`theorem_d`], [`prop_s_6`] to [`prop_s_10`] |
//! | 9, excess of length | two curves, or a [`Reconstruction`] | [`prop_9_1`], [`remark_9_2`] |
//!
//! A [`Subject`] is the implementation under test: [`LIBRARY`], or the library with the mistake of
//! a [`Mutant`]. [`curves`] contains the curves of Sections 3, 4, 6 and 7, and [`witnesses`]
//! contains the cases near equality.

mod curvature;
pub mod curves;
mod errata;
mod evidence;
mod gram_range;
mod inequality;
mod known;
mod mutants;
mod reconstruction;
mod refutations;
mod replaceable;
mod slope;
mod statement;
mod statements;
mod subject;
mod units;
mod verdict;
mod verify_error;
mod with_constants;
pub mod witnesses;

pub use curvature::curvature_along;
pub use errata::{Erratum, errata};
pub use evidence::{Evidence, Finding};
pub use gram_range::{GramRange, extreme_eigenvalues, operator_norm};
pub use inequality::{Inequality, Source, Unit};
pub use known::Known;
pub use mutants::Mutant;
pub use reconstruction::{Reconstruction, discrete_energy, mean_power, nodes};
pub use replaceable::{Asked, Bounds};
pub use slope::slope;
pub use statement::Statement;
pub use statements::*;
pub use subject::{LIBRARY, Subject};
pub use tautline::bounds::PaperRule;
pub use units::{InUnits, Units};
pub use verdict::Verdict;
pub use verify_error::VerifyError;
pub use with_constants::{AnyBounded, WithConstants};
