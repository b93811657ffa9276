//! Curves: rigorous bounds on energies, lengths and distances.

mod admissible_curve;
mod chord;
mod pairwise_sum;
mod polygon;
mod stationarity;
mod taylor;

pub use admissible_curve::{AdmissibleCurve, CurveError, is_metric_at};
pub use polygon::Polygon;
