//! Curves: rigorous bounds of energies and lengths, and what they prove of a distance.

mod admissible_curve;
mod chord;
mod pairwise_sum;
mod polygon;
mod taylor;

pub use admissible_curve::{AdmissibleCurve, CurveError};
pub use polygon::Polygon;
