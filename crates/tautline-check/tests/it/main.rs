//! Tests of the checker through its public interface.

mod extreme_numbers;
mod helpers;
mod hostile_values;
mod invariances;
mod known_distances;
mod tampering;
mod threads;
mod unbounded_sets;
mod wave;
