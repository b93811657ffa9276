//! Proofs about metrics and curves, compared with exact values and with high precision.

mod aligned_waves;
mod curve_laws;
mod curve_values;
mod every_metric;
mod exact_constants;
mod extreme_formulas;
mod gallery_constants;
mod many_dimensions;
mod metrics_against_high_precision;
mod partly_undefined;
#[path = "../../../tautline-scalar/tests/it/precise/mod.rs"]
mod precise;
#[path = "../../../tautline-scalar/tests/it/reference/mod.rs"]
mod reference;

/// Returns the metric with this text.
fn parsed<const D: usize>(text: &str) -> tautline_formula::Formula<D> {
    tautline_formula::Formula::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"))
}
