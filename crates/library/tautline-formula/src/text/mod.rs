//! Formulas as text: parsing and printing.

mod expression;
mod form;
mod gradient;
mod help;
mod meant;
mod parser;
mod print;
mod text_error;
mod token;
mod value;
mod written;

pub use form::Form;
pub use meant::probably_meant;
pub use text_error::{Problem, TextError};
pub use written::{Part, Weight, Written, WrittenError, number};
