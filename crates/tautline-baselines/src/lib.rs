//! The other ways to a minimal geodesic, to compare with.
//!
//! Each module computes geodesics of a [`Metric`](tautline::Metric) by another method than the
//! minimisation of a discrete energy. They need the formula of the metric alone: all derivatives
//! come from jets.

// By the differential equation of a geodesic, and by its discrete counterpart.
pub mod collocation;
pub mod geodesic_calculus;
mod geodesic_equation;
mod normal_map;
pub mod shooting;

pub use geodesic_equation::EquationError;
