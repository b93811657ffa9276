//! The other ways to a minimal geodesic, to compare with.
//!
//! | | method | ends |
//! | --- | --- | --- |
//! | [`descent`] | other minimisers of a discrete energy: gradients in a Sobolev norm, L-BFGS, dynamic programming, also on a surface | two points |
//! | [`equal_speeds`] | the minimiser of a discrete energy among sequences of equal speeds, of Liu et al. | two points |
//! | [`shooting`] | the initial velocity of a geodesic, by Newton's method; exponential map and logarithm | two closed sets |
//! | [`collocation`] | the boundary value problem of a geodesic | two closed sets |
//! | [`geodesic_calculus`] | discrete exponential, logarithm and parallel transport | two points |
//! | [`graph()`] | shortest paths along a lattice | two closed sets |
//! | [`eikonal()`] | the distance from a set at the nodes of a lattice, by fast marching | two closed sets |
//!
//! They need the formula of the metric alone: all derivatives come from it. The last two see the
//! whole of a box, in up to three or four dimensions; the others are local. A path along a lattice
//! becomes a start of the local ones by its `sequence(n)`: see [`Starts::Only`](tautline::Starts::Only)
//! and [`Collocation::start`](collocation::Collocation::start).

pub mod collocation;
pub mod descent;
mod eikonal;
pub mod equal_speeds;
pub mod geodesic_calculus;
mod geodesic_equation;
mod graph;
mod normal_map;
mod not_finite;
pub mod shooting;

pub use eikonal::{Distances, Eikonal, EikonalError, EikonalPath, eikonal};
pub use geodesic_equation::EquationError;
pub use graph::{angular_factor, graph};
