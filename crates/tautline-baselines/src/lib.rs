//! The other ways to a minimal geodesic, to compare with.
