//! What intervals prove about a metric and a curve.
//!
//! Everything here is computed from the formula of the metric alone, with outward rounding, and
//! holds for all points of a box at once: nothing is sampled.

mod branch_and_bound;
mod cell;
mod certified;
mod certify_error;
mod constants;
mod domain;
mod effort;
mod formula;
mod locally_certified;

pub use cell::Cell;
pub use certified::Certified;
pub use certify_error::CertifyError;
pub use constants::{CertifiedConstant, CertifiedConstants, Quantity, certify};
pub use domain::Domain;
pub use effort::Effort;
pub use locally_certified::LocallyCertified;
