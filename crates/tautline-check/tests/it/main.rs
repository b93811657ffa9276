//! Tests of the checker through its public interface.

mod extreme_numbers;
mod helpers;
mod known_distances;
