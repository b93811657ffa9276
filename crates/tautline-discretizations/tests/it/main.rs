//! The rules against exact values and differences.

mod derivatives;
mod values;
