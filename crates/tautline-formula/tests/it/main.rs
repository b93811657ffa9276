//! Formulas as data: recorded, printed, and read from text.

mod any_metric;
mod broken_text;
mod edges_of_programs;
mod programs;
mod random;
mod random_formulas;
mod recorded;
mod squares;
mod text;
