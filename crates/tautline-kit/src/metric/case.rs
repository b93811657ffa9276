//! `Case`: a metric as the laws see it.

use std::sync::Arc;

use nalgebra::SVector;
use tautline::{Bounded, Constants};
use tautline_statements::{AnyBounded, WithConstants};

use super::memory::Solved;
use crate::{Effort, Region};

/// The distance of two points, where a metric knows it, in `m`.
type Distance<'m, const D: usize> =
    Box<dyn Fn(&SVector<f64, D>, &SVector<f64, D>) -> Option<f64> + 'm>;

/// A metric behind a pointer, where to look, and for how long.
pub(super) struct Case<'m, const D: usize> {
    pub(super) metric: AnyBounded<'m, D>,
    pub(super) region: Region<D>,
    /// Where the ends of problems are.
    pub(super) ends: Region<D>,
    pub(super) effort: Effort,
    pub(super) distance: Option<Distance<'m, D>>,
    /// What several laws need of the same problems.
    pub(super) solved: Arc<Solved<D>>,
}

impl<'m, const D: usize> Case<'m, D> {
    /// Points to a metric.
    pub(super) fn new(metric: &'m impl Bounded<D>, region: Region<D>, effort: Effort) -> Self {
        Self::of(AnyBounded::of(metric), region, effort)
    }

    /// The same metric, of which other constants are claimed.
    pub(super) fn claiming(&self, constants: Constants, effort: Effort) -> Self {
        let metric = WithConstants { metric: self.metric.metric.clone(), constants };
        Self::of(metric, self.region, effort)
    }

    fn of(metric: AnyBounded<'m, D>, region: Region<D>, effort: Effort) -> Self {
        Self { metric, region, ends: region, effort, distance: None, solved: Arc::default() }
    }
}
