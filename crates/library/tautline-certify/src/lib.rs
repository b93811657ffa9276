//! Rigorous bounds, proved by intervals, for metrics and curves.
//!
//! Everything is computed from the formula of the metric alone, with outward rounding. The results
//! hold for all points of a box at once: nothing is sampled.
//!
//! * [`certify`] and [`CertifiedConstants`] bound the constants `c₁`, `c₂`, `L_H` and `M_H` on a
//!   box, a ball or all of space. [`Certified`] and [`LocallyCertified`] are metrics with these
//!   constants.
//! * [`Polygon`] encloses the energy and the length of a polygon. [`AdmissibleCurve`] turns them
//!   into a bound on the distance between two sets.
//!
//! ```
//! use tautline_certify::{Domain, Accuracy, Quantity, certify};
//! use tautline_metrics::gallery::Shear;
//!
//! // The pullback by (x₁ + ½ sin x₂, x₂): L_H = √5/4.
//! let shear = Shear::new(0.5, 1.0)?;
//! let found = certify(&shear, Quantity::LH, &Domain::space(&shear), Accuracy::default())?;
//! assert!(found.contains(5.0_f64.sqrt() / 4.0) && found.looseness() < 1.001);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Trust base
//!
//! The numbers of this crate hold if you trust
//!
//! * the trust base of [`Interval`](tautline_scalar::Interval): `+ − × ÷ √` of doubles are rounded
//!   as IEEE 754 demands, the compiler and the processor are correct, and so are the derivations in
//!   the comments of the intervals;
//! * the implementation of jets, of the theorems of Gershgorin and of Collatz and Wielandt, of
//!   Taylor's formula and of the search;
//! * the formula: it is the one you mean, with its decimals read as doubles; it computes the same
//!   function in all number types; and it is recorded and evaluated as written;
//! * your word, if you [declare a metric to settle](Domain::settled_space).
//!
//! Nothing computed in plain doubles is trusted. Eigenvectors, choices and best points are guesses,
//! and a bad guess makes a bound useless, not wrong. No mathematical library, linear algebra or
//! optimiser is part of the trust base.
//!
//! # Features
//!
//! `serde`, off by default: [`Accuracy`], in which fields may be missing, [`CertifiedConstant`] and
//! [`Quantity`] are written and read by their names. [`CertifiedConstants`] are only written, since
//! nothing proves what is read.

mod accuracy;
mod branch_and_bound;
mod cell;
mod certified;
mod certify_error;
mod constants;
mod curves;
mod domain;
mod formula;
mod locally_certified;
mod patch;
mod progress;
#[cfg(test)]
mod testing;

pub use accuracy::Accuracy;
pub use cell::Cell;
pub use certified::Certified;
pub use certify_error::CertifyError;
pub use constants::{CertifiedConstant, CertifiedConstants, Quantity, certify, certify_by_formula};
pub use curves::{AdmissibleCurve, CurveError, Polygon, is_metric_at};
pub use domain::Domain;
pub use formula::is_isotropic;
pub use locally_certified::{LocallyCertified, constants_within};
pub use progress::{Progress, Watch};
