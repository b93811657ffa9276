//! Problems and counterexamples that are shared by several checks.

mod above_exponential;
mod admissible;
mod claiming;
pub(super) mod clauses;
mod known_geodesic;
mod missing_point;
mod random_problems;
pub(super) mod routes;

pub(super) use above_exponential::AboveExponential;
pub(super) use admissible::admissible;
pub(super) use claiming::claiming;
pub(super) use known_geodesic::{known_geodesic, sheared};
pub(super) use missing_point::round_the_missing_point;
pub(super) use random_problems::{Problems, Question};
