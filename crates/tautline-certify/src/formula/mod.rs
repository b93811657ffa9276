//! What the formula of a metric shows when it is read, not evaluated: periods, directions along
//! which it does not change, multiples of the identity.
//!
//! A metric is generic over its numbers, so it can be evaluated in numbers that keep track of how
//! they were made. What they find is proved for the formula as it is written, with the doubles in
//! it as exact numbers; what they do not find costs time and nothing else.

mod dependence;
mod expression;
mod invariance;
#[cfg(test)]
mod laws;
mod operators;

pub(crate) use dependence::{Along, Dependence};
pub(crate) use expression::{is_isotropic, is_radial};
pub(crate) use invariance::superfluous;
