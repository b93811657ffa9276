//! Tests of the checker through its public interface.

mod helpers;
mod known_distances;
