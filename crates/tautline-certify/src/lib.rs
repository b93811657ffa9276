//! What intervals prove about a metric and a curve.
//!
//! Everything here is computed from the formula of the metric alone, with outward rounding, and
//! holds for all points of a box at once: nothing is sampled.
//!
//! * The constants `c₁`, `c₂`, `L_H` and `M_H` on a box, a ball or all of space: [`certify`],
//!   [`CertifiedConstants`]; as a metric that has them, [`Certified`] and [`LocallyCertified`].
//! * The energy and the length of a polygon, [`Polygon`], and the bound of the distance of two sets
//!   that it proves, [`AdmissibleCurve`].
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
//! What has to be believed for a number of this crate to hold: the trust base of
//! [`Interval`](tautline_scalar::Interval), that is, that `+ − × ÷ √` of doubles are rounded as
//! IEEE 754 demands, that the compiler and the processor do what they say, and that the derivations
//! in the comments of the intervals are right; that jets, Gershgorin's and Collatz and Wielandt's
//! theorems, Taylor's formula and the search are implemented as they are described here; that the
//! formula of the metric is the one that is meant, its decimals read as doubles, asks the same of all
//! numbers, and is recorded and evaluated from its record as it is written; and, where a metric is [declared to
//! settle](Domain::settled_space), that word. Nothing that is computed in plain doubles is
//! believed: eigenvectors, choices and the best points found are guesses, which a bad one makes
//! useless but not wrong. In particular no mathematical library, no linear algebra and no optimiser
//! is part of it.

mod accuracy;
mod branch_and_bound;
mod cell;
mod certified;
mod certify_error;
mod constants;
mod curves;
mod domain;
#[cfg(test)]
mod domain_laws;
mod formula;
mod locally_certified;

pub use accuracy::Accuracy;
pub use cell::Cell;
pub use certified::Certified;
pub use certify_error::CertifyError;
pub use constants::{CertifiedConstant, CertifiedConstants, Quantity, certify};
pub use curves::{AdmissibleCurve, CurveError, Polygon};
pub use domain::Domain;
pub use locally_certified::LocallyCertified;
