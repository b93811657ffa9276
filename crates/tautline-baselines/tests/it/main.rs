//! Tests the other ways to a minimal geodesic, against known distances and against each other.

mod charts;
mod collocation;
mod constrained;
mod descents;
mod equal_speeds;
mod geodesic_calculus;
mod graphs;
mod grid_errors;
mod impossible_constraints;
mod marching;
mod marching_paths;
mod orders;
mod problems;
mod random_cases;
mod shooting;
mod units;
