//! Formulas as data: recorded, printed, and read from text.

mod broken_text;
mod random;
mod random_formulas;
mod text;
