//! Formulas as text: parsing and printing.

mod expression;
mod form;
mod gradient;
mod parser;
mod print;
mod text_error;
mod token;
mod value;

pub use text_error::{Problem, TextError};
