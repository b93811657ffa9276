//! Tests the methods of the ODE kind against known distances, exact formulas and each other.

mod collocation;
mod geodesic_calculus;
mod problems;
mod random_cases;
mod shooting;
