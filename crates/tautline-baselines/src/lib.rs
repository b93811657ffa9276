//! The other ways to a minimal geodesic, to compare with.
//!
//! | module | method | ends |
//! | --- | --- | --- |
//! | [`descent`] | other minimisers of a discrete energy: gradients in a Sobolev norm, L-BFGS, dynamic programming | two points |
//! | [`shooting`] | the initial velocity of a geodesic, by Newton's method; exponential map and logarithm | two closed sets |
//! | [`collocation`] | the boundary value problem of a geodesic | two closed sets |
//! | [`geodesic_calculus`] | discrete exponential, logarithm and parallel transport | two points |
//!
//! They need the formula of the metric alone: all derivatives come from jets.

pub mod collocation;
pub mod descent;
pub mod geodesic_calculus;
mod geodesic_equation;
mod normal_map;
pub mod shooting;

pub use geodesic_equation::EquationError;
