//! The other ways to a minimal geodesic, to compare with.

mod eikonal;
mod graph;
pub use eikonal::{Distances, Eikonal, EikonalError, EikonalPath, eikonal};
pub use graph::{angular_factor, graph};
