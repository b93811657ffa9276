//! Tests the search for discrete minimisers: problems of every kind, bad input, and the claims that
//! results make.

mod bad_input;
mod benchmark_problems;
mod between_nodes;
mod damped_steps;
mod degenerate;
mod large_grids;
mod left_behind;
mod little_memory;
mod nasty_metrics;
mod pieces;
mod random_cases;
mod rules;
mod same_bits;
mod set_ends;
mod setup;
mod small_grids;
mod units;
mod watched;
