//! Formulas as text: read and printed.

mod form;
mod gradient;
mod parser;
mod print;
mod text_error;
mod token;
mod value;

pub use text_error::{Problem, TextError};
