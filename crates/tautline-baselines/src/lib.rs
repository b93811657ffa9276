//! The other ways to a minimal geodesic, to compare with.
//!
//! [`graph`] is a shortest path along the nodes of a lattice, and [`eikonal`] a path that descends the
//! distances of fast marching. Both need a lattice of all places, and find a global minimum up to its
//! spacing.

mod eikonal;
mod graph;

pub use eikonal::{Distances, Eikonal, EikonalError, EikonalPath, eikonal};
pub use graph::{angular_factor, graph};
