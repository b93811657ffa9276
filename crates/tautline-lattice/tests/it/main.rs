//! Lattices, and shortest paths along them.

mod class_paths;
mod graph_paths;
mod lattices;
mod punctures;
