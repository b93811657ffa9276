//! `Case`: a metric in the form in which the laws use it.

use std::sync::Arc;

use nalgebra::SVector;
use tautline::{Bounded, Constants};
use tautline_statements::{AnyBounded, WithConstants};

use super::memory::Solved;
use crate::{Effort, Fault, Region, report::LawResult};

/// Returns the distance between two points, in `m`, if the metric knows it.
type Distance<'m, const D: usize> =
    Box<dyn Fn(&SVector<f64, D>, &SVector<f64, D>) -> Option<f64> + 'm>;

/// A metric with its type erased, the region to sample, and the effort.
pub(super) struct Case<'m, const D: usize> {
    pub(super) metric: AnyBounded<'m, D>,
    pub(super) region: Region<D>,
    /// The region in which the ends of problems lie.
    pub(super) ends: Region<D>,
    pub(super) effort: Effort,
    pub(super) distance: Option<Distance<'m, D>>,
    /// Results that several laws share.
    pub(super) solved: Arc<Solved<D>>,
}

impl<'m, const D: usize> Case<'m, D> {
    /// Erases the type of a metric.
    pub(super) fn new(metric: &'m impl Bounded<D>, region: Region<D>, effort: Effort) -> Self {
        Self::of(AnyBounded::of(metric), region, effort)
    }

    /// Returns a case of the same metric with other claimed constants.
    pub(super) fn claiming(&self, constants: Constants, effort: Effort) -> Self {
        let metric = WithConstants { metric: self.metric.metric.clone(), constants };
        Self::of(metric, self.region, effort)
    }

    fn of(metric: AnyBounded<'m, D>, region: Region<D>, effort: Effort) -> Self {
        Self { metric, region, ends: region, effort, distance: None, solved: Arc::default() }
    }

    /// Checks a law at random points.
    pub(super) fn at_points(
        &self,
        law: impl Fn(&SVector<f64, D>) -> Result<f64, Fault>,
    ) -> LawResult {
        self.effort.for_all(self.region.points(), law)
    }
}
