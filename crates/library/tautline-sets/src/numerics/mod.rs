//! The arithmetic of sets: points as slices, norms that do not overflow, and proofs.

#[cfg(test)]
pub(crate) mod exact;
pub(crate) mod norm;
pub(crate) mod place;
pub(crate) mod proof;
