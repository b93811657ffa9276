//! `Known`: a metric by its formula or by its values.

use std::sync::Arc;

use tautline::{BlackBox, Formula, Metric, Prepared, SMatrix, SVector, Scalar, Values};

use super::GivenError;

/// A metric as a program gives it. All that is compiled for a dimension is compiled once for both.
#[derive(Clone, Debug)]
pub(super) enum Known<const D: usize> {
    Formula(Formula<D>),
    BlackBox(BlackBox<D>),
}

impl<const D: usize> Metric<D> for Known<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        match self {
            Known::Formula(formula) => formula.gram(x),
            Known::BlackBox(black_box) => black_box.gram(x),
        }
    }
}

/// Returns the metric of a black box, ready for batches.
pub(super) fn black_box<const D: usize>(
    values: Arc<dyn Values>,
    step: f64,
) -> Result<Prepared<Known<D>, D>, GivenError> {
    let black_box = BlackBox::new(values, step).ok_or(GivenError::Step { step })?;
    Ok(Prepared::of_black_box(Known::BlackBox(black_box.clone()), black_box))
}
