//! What the formula of a metric shows when it is read rather than evaluated: periods, directions
//! along which it does not change, and multiples of the identity.
//!
//! What is found is proved for the formula as written, with its doubles as exact numbers. What is
//! missed only costs time.

mod dependence;
mod expression;
mod invariance;
#[cfg(test)]
mod laws;

pub(crate) use dependence::{Along, dependence};
pub use expression::is_isotropic;
pub(crate) use expression::is_radial;
pub(crate) use invariance::superfluous;
