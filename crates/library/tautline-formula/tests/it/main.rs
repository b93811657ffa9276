//! Formulas as data: recorded, printed, parsed, and run as programs.

mod any_dimension;
mod any_metric;
mod batches;
mod black_box;
mod broken_text;
mod edges_of_programs;
mod programs;
mod random;
mod random_formulas;
mod recorded;
mod spline;
mod squares;
mod tables;
mod text;
mod written;

/// Returns the metric with this text.
fn parsed<const D: usize>(text: &str) -> tautline_formula::Formula<D> {
    tautline_formula::Formula::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"))
}
