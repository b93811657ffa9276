//! Lattices, shortest paths along them, fast marching and passes.

mod class_paths;
mod graph_paths;
mod graphs;
mod grid_errors;
mod lattices;
mod marching;
mod marching_paths;
mod orders;
mod passes;
mod punctures;
