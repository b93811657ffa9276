//! Formulas as text: read and printed.

mod parser;
mod print;
mod text_error;
mod token;
mod value;

pub use text_error::{Problem, TextError};
