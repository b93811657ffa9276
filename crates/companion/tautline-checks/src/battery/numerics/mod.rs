//! Compares the programs with theory and with reference values: orders of convergence, gradients,
//! global minima, golden numbers, enclosures.

pub(super) mod global_minima;
pub(super) mod golden;
pub(super) mod gradients;
pub(super) mod leading_constants;
pub(super) mod orders;
pub(super) mod proved_numbers;
pub(super) mod tables;
