//! The rules against exact values and independent derivatives.

mod derivatives;
mod values;
