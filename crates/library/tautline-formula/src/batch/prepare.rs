//! `Prepare`: what a metric becomes when it is evaluated in batches.

use tautline_metrics::Metric;
use tautline_scalar::ANY;

use crate::{
    Formula, RecordError,
    batch::{AnyBatches, Known, Prepared},
};

/// A metric that can be made ready for batches: a [`Metric`] on `R^D`, or one that is
/// [`Known`] in a dimension that is a value, for which `D` is [`ANY`].
pub trait Prepare<const D: usize>: Sized {
    /// The metric with its programs.
    type Prepared: AnyBatches;

    /// Makes the metric ready.
    fn prepare(self) -> Self::Prepared;

    /// Returns the metric.
    fn metric(prepared: &Self::Prepared) -> &Self;

    /// Returns the formula of the metric.
    ///
    /// # Errors
    ///
    /// [`RecordError`] if it is not known.
    fn formula(prepared: &Self::Prepared) -> Result<&Formula<D>, RecordError>;

    /// Returns the metric for a single evaluation. A [`Metric`] is evaluated as compiled, without a
    /// program.
    fn plain(prepared: &Self::Prepared) -> &dyn AnyBatches;
}

impl<M: Metric<D>, const D: usize> Prepare<D> for M {
    type Prepared = Prepared<M, D>;

    fn prepare(self) -> Prepared<M, D> {
        Prepared::new(self)
    }

    fn metric(prepared: &Prepared<M, D>) -> &Self {
        prepared.metric()
    }

    fn formula(prepared: &Prepared<M, D>) -> Result<&Formula<D>, RecordError> {
        prepared.recorded()
    }

    fn plain(prepared: &Prepared<M, D>) -> &dyn AnyBatches {
        prepared.plain()
    }
}

impl Prepare<ANY> for Known {
    type Prepared = Self;

    fn prepare(self) -> Self {
        self
    }

    fn metric(prepared: &Self) -> &Self {
        prepared
    }

    fn formula(prepared: &Self) -> Result<&Formula<ANY>, RecordError> {
        prepared.formula()
    }

    fn plain(prepared: &Self) -> &dyn AnyBatches {
        prepared
    }
}
