//! Tests the other ways to a minimal geodesic, against known distances and against each other.

mod charts;
mod collocation;
mod constrained;
mod descents;
mod equal_speeds;
mod geodesic_calculus;
mod impossible_constraints;
mod problems;
mod random_cases;
mod shooting;
mod units;
