//! Section 1: observed orders and leading constants, the sharp companions of the theorems.

mod leading_constants;
mod orders;
mod slope;

pub(crate) use slope::slope;
