//! Ends, starts, solves and comparisons that the tests share.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{PointSequence, Rule};
use tautline_metrics::{
    Metric,
    gallery::{Bump, Constant},
};
use tautline_optimizers::{Minimum, Options, Starts, extrapolate, minimise};
use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace, Point};

pub(crate) fn point<const D: usize>(x: impl Into<SVector<f64, D>>) -> Point<D> {
    Point::new(x.into()).expect("finite")
}

pub(crate) fn ball<const D: usize>(centre: impl Into<SVector<f64, D>>, radius: f64) -> Ball<D> {
    Ball::new(centre.into(), radius).expect("a radius")
}

/// Returns `{x : normal · x ≥ offset}`.
pub(crate) fn half_space<const D: usize>(
    normal: impl Into<SVector<f64, D>>,
    offset: f64,
) -> HalfSpace<D> {
    HalfSpace::at_least(normal.into(), offset).expect("a normal")
}

pub(crate) fn between<const D: usize>(
    first: impl ClosedSet<D> + 'static,
    second: impl ClosedSet<D> + 'static,
) -> Ends<D> {
    Ends::new(first, second).expect("one bounded")
}

/// Returns two points as ends.
pub(crate) fn from_to<const D: usize>(
    a: impl Into<SVector<f64, D>>,
    b: impl Into<SVector<f64, D>>,
) -> Ends<D> {
    Ends::points(a.into(), b.into()).expect("finite")
}

pub(crate) fn sequence<const D: usize>(points: Vec<SVector<f64, D>>) -> PointSequence<D> {
    PointSequence::new(points).expect("finite")
}

pub(crate) fn straight<const D: usize>(
    a: impl Into<SVector<f64, D>>,
    b: impl Into<SVector<f64, D>>,
    n: usize,
) -> PointSequence<D> {
    PointSequence::straight(a.into(), b.into(), n).expect("finite")
}

/// Returns the identity as a metric.
pub(crate) fn euclidean<const D: usize>() -> Constant<D> {
    Constant::new(SMatrix::identity()).expect("positive definite")
}

/// Returns the bump of problems P2 and P4.
pub(crate) fn bump() -> Bump {
    Bump::new(4.0, 0.5).expect("positive")
}

/// Returns options for a search from this start alone.
pub(crate) fn only<const D: usize>(start: PointSequence<D>) -> Options<D> {
    Options { starts: Starts::Only(vec![start]), ..Options::default() }
}

/// Returns the minimum from all automatic starts.
#[track_caller]
pub(crate) fn lowest<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
) -> Minimum<D> {
    minimise(metric, ends, rule, n, &Options::default()).expect("a metric")
}

/// Returns `d²`, extrapolated from trapezoidal energies.
#[track_caller]
pub(crate) fn extrapolated<const D: usize>(minimum: &Minimum<D>) -> f64 {
    extrapolate(&minimum.levels, 2).expect("several grids").value
}

#[track_caller]
pub(crate) fn assert_close(value: f64, reference: f64, relative: f64) {
    let error = value / reference - 1.0;
    assert!(error.abs() <= relative, "{value:.15e} is not {reference:.15e}: {error:e}");
}
