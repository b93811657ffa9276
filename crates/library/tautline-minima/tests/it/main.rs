//! Tests of the search for all minima.

mod bad_input;
mod continuation;
mod landscapes;
mod obstacles;
mod passes;
mod setup;
