//! Dynamic programming with equality constraints, by a primal-dual augmented Lagrangian.

mod augmented;
mod constrained_error;
mod equality;
mod leap;
mod primal_dual;

pub use constrained_error::ConstrainedError;
pub use equality::Equality;
pub use primal_dual::{Constrained, constrained_dynamic_programming};
