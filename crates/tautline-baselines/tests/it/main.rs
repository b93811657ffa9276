//! Tests the methods of the ODE kind against known distances, exact formulas and each other.

mod collocation;
mod problems;
mod shooting;
