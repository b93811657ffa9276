//! Lattices, and shortest paths along them.

mod graph_paths;
mod lattices;
