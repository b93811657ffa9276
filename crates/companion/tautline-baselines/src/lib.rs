//! The other ways to a minimal geodesic, to compare with.
//!
//! | | method | ends |
//! | --- | --- | --- |
//! | [`descent`] | other minimisers of a discrete energy: gradients in a Sobolev norm, L-BFGS, dynamic programming, also on a surface | two points |
//! | [`equal_speeds`] | the minimiser of a discrete energy among sequences of equal speeds, of Liu et al. | two points |
//! | [`shooting`] | the initial velocity of a geodesic, by Newton's method; exponential map and logarithm | two closed sets |
//! | [`collocation`] | the boundary value problem of a geodesic | two closed sets |
//! | [`geodesic_calculus`] | discrete exponential, logarithm and parallel transport | two points |
//!
//! They need the formula of the metric alone: all derivatives come from it. They are local. Shortest paths
//! along a lattice and fast marching see the whole of a box ([`tautline::grid`]); such a path becomes a
//! start of the local methods by its `sequence(n)`: see [`Starts::Only`](tautline::Starts::Only) and
//! [`Collocation::start`](collocation::Collocation::start).

pub mod collocation;
pub mod descent;
pub mod equal_speeds;
pub mod geodesic_calculus;
mod geodesic_equation;
mod normal_map;
mod not_finite;
pub mod shooting;

pub use geodesic_equation::EquationError;
