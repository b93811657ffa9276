//! The methods beside distances that are known.

mod graphs;
mod grid_errors;
mod marching;
mod marching_paths;
mod orders;
