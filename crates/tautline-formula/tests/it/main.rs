//! Formulas as text.

mod broken_text;
mod text;
