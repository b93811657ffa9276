//! The other ways to a minimal geodesic, to compare with.
//!
//! [`descent`] has other minimisers of the discrete energies.

pub mod descent;
