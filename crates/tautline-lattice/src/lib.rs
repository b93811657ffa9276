//! Shortest paths along the nodes of a lattice.
//!
//! A lattice sees the whole of a box, so that its paths are no local minima. They run in a few
//! directions only, so that they are too long by some per cent: they are starts of searches
//! ([`graph_path`]), and a method to compare with ([`LatticeGraph`]).

mod graph_path;
mod lattice;
mod lattice_graph;

pub use graph_path::{GraphPathError, equal_chords, graph_path};
pub use lattice::Lattice;
pub use lattice_graph::{LatticeGraph, LatticePath};
