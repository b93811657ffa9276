//! Tests of the checker through its public interface.

mod budget;
mod chain;
mod domain;
mod extreme_numbers;
mod files;
mod helpers;
mod hostile_values;
mod invariances;
mod known_distances;
mod pieces;
mod program;
mod regions;
mod tables;
mod tampering;
mod threads;
mod unbounded_sets;
mod unions;
mod wave;
