//! What intervals prove about a metric and a curve.
//!
//! Everything here is computed from the formula of the metric alone, with outward rounding, and
//! holds for all points of a box at once: nothing is sampled.

mod curves;

pub use curves::{AdmissibleCurve, CurveError, Polygon};
