//! Bounds on the elementary functions at a double, in one file each, and the kernel that uses them.

pub(crate) mod arctangent;
pub(crate) mod circular;
pub(crate) mod constants;
pub(crate) mod even_odd;
pub(crate) mod exponential;
mod hyperbolic;
pub(crate) mod logarithm;
pub(crate) mod quarter_turns;
mod rigorous;
