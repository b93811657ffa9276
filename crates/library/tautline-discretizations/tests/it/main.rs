//! Compares the rules with exact values and independent derivatives.

mod batches;
mod derivatives;
mod gaps;
mod values;
