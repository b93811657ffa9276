//! Tests the other ways to a minimal geodesic, against known distances and against each other.

mod descents;
