//! Shortest paths along the nodes of a lattice.
//!
//! A lattice sees the whole of a box, so that its paths are more than local minima. They run in a few
//! directions only, so that they are too long by some per cent: they are starts of searches
//! ([`graph_path`]), and a method to compare with ([`LatticeGraph`]). With the peaks and holes of a metric
//! as [`Punctures`] there is a shortest path for each way around them ([`class_paths`]).

mod class_paths;
mod graph_path;
mod lattice;
mod lattice_graph;
mod lattice_path;
mod peaks;
mod punctures;
mod word;

pub use class_paths::{ClassPath, class_paths};
pub use graph_path::{GraphPathError, equal_chords, graph_path};
pub use lattice::Lattice;
pub use lattice_graph::LatticeGraph;
pub use lattice_path::LatticePath;
pub use punctures::Punctures;
pub use word::Word;
