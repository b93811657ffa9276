//! The comparison of methods: what each of them is, three problems, and random ones.

mod method;
mod problems;
#[cfg(feature = "tables")]
pub(crate) mod random;
mod task;
#[cfg(feature = "tables")]
mod traits;

pub(crate) use method::Method;
pub(crate) use problems::{columns, problems};
