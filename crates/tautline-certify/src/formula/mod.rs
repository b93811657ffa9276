//! What the formula of a metric shows when it is read rather than evaluated: periods, directions
//! along which it does not change, and multiples of the identity.
//!
//! What is found is proved for the formula as written, with its doubles as exact numbers. What is
//! missed only costs time.

mod dependence;
mod expression;
mod form;
mod hill;
mod invariance;
#[cfg(test)]
mod laws;
mod lift;
mod wall;

pub(crate) use dependence::{Along, dependence};
pub use expression::is_isotropic;
pub(crate) use expression::is_radial;
pub(crate) use form::Place;
pub(crate) use invariance::superfluous;
pub(crate) use lift::{Lift, Role, operate};
pub(crate) use wall::Wall;
