//! Compares the rules with exact values and independent derivatives.

mod derivatives;
mod values;
