//! Problems in a region: pairs of sets of every kind, with known or estimated distances.

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{
    AxisBox, Ball, Bounded, Ends, FiniteSet, HalfSpace, Options, Point, SetError, Starts,
    Trapezoidal, extrapolate, minimise,
};
use tautline_statements::{AnyBounded, Known, Reconstruction, VerifyError};

use super::case::Case;
use crate::Region;

/// The grid from which a distance is extrapolated, over 8, 32 and 128.
const REFERENCE: usize = 512;

/// The kinds of the two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Points,
    BallToBall,
    BallToHalfSpace,
    BoxToBall,
    PointToFiniteSet,
    FiniteSetToBox,
}

impl Kind {
    pub(super) const ALL: [Kind; 6] = [
        Kind::Points,
        Kind::BallToBall,
        Kind::BallToHalfSpace,
        Kind::BoxToBall,
        Kind::PointToFiniteSet,
        Kind::FiniteSetToBox,
    ];
}

/// Two sets about `a` and `b`, apart from each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Posed<const D: usize> {
    kind: Kind,
    a: SVector<f64, D>,
    b: SVector<f64, D>,
    further: SVector<f64, D>,
}

impl<const D: usize> Posed<D> {
    /// Problems of one kind, with `a` and `b` at least an eighth of the longest edge apart. No
    /// point is special, since between two points on an axis of symmetry there may be a saddle.
    pub(super) fn problems(kind: Kind, region: &Region<D>) -> impl Strategy<Value = Self> + use<D> {
        let apart = region.size() / 8.0;
        (region.uniform(), region.uniform(), region.uniform())
            .prop_filter("the sets are apart", move |(a, b, further)| {
                (b - a).norm() >= apart && (further - a).norm() >= apart
            })
            .prop_map(move |(a, b, further)| Self { kind, a, b, further })
    }

    /// The problem between two points.
    pub(super) fn between(a: SVector<f64, D>, b: SVector<f64, D>) -> Self {
        Self { kind: Kind::Points, a, b, further: b }
    }

    /// The two sets. Radii, and half the diagonals of boxes, are a quarter of `|b − a|`.
    pub(super) fn ends(&self) -> Result<Ends<D>, SetError> {
        let Self { a, b, further, .. } = *self;
        let radius = self.radius();
        let half = [radius / (D as f64).sqrt(); D];
        match self.kind {
            Kind::Points => Ends::points(a, b),
            Kind::BallToBall => Ends::new(Ball::new(a, radius)?, Ball::new(b, radius)?),
            Kind::BallToHalfSpace => {
                let normal = b - a;
                Ends::new(Ball::new(a, radius)?, HalfSpace::at_least(normal, normal.dot(&b))?)
            }
            Kind::BoxToBall => Ends::new(AxisBox::new(a, half)?, Ball::new(b, radius)?),
            Kind::PointToFiniteSet => {
                Ends::new(FiniteSet::new([a])?, FiniteSet::new([b, further])?)
            }
            Kind::FiniteSetToBox => {
                // `further` may lie in the box, at the distance 0, so the second point mirrors `b`.
                let mirrored = a * 2.0 - b;
                Ends::new(FiniteSet::new([a, mirrored])?, AxisBox::new(b, half)?)
            }
        }
    }

    /// The two sets near these members, with a finite set replaced by its member.
    pub(super) fn ends_near(
        &self,
        [first, last]: [SVector<f64, D>; 2],
    ) -> Result<Ends<D>, SetError> {
        match self.kind {
            Kind::PointToFiniteSet => Ends::points(first, last),
            Kind::FiniteSetToBox => {
                let half = [self.radius() / (D as f64).sqrt(); D];
                Ends::new(Point::new(first)?, AxisBox::new(self.b, half)?)
            }
            _ => self.ends(),
        }
    }

    fn radius(&self) -> f64 {
        0.25 * (self.b - self.a).norm()
    }

    /// A third point, at least an eighth of the longest edge from `a`.
    pub(super) fn further(&self) -> SVector<f64, D> {
        self.further
    }

    /// The two points, if the sets are points.
    pub(super) fn points(&self) -> Option<[SVector<f64, D>; 2]> {
        (self.kind == Kind::Points).then_some([self.a, self.b])
    }
}

impl<'m, const D: usize> Case<'m, D> {
    /// The problem with its distance: exact where the metric knows it, else extrapolated from a
    /// fine grid.
    ///
    /// The error of an estimate is ten times its last change by extrapolation, plus `10⁻¹³` for
    /// rounding. Curves from other grids that may be `shorter` are starts of the fine grid.
    pub(super) fn known(
        &self,
        posed: &Posed<D>,
        shorter: &[Reconstruction<D>],
    ) -> Result<Known<&AnyBounded<'m, D>, D>, VerifyError> {
        let metric = &self.metric;
        if let (Some(distance), Some([a, b])) = (&self.distance, posed.points())
            && let Some(distance) = distance(&a, &b)
        {
            return Ok(self.exact([a, b], posed.ends()?, distance));
        }
        if !shorter.is_empty() {
            return estimated(metric, posed.ends()?, shorter);
        }
        let estimate = self.solved.distances.recall(posed, || {
            let known = estimated(metric, posed.ends()?, &[])?;
            Ok([known.distance, known.distance_error])
        })?;
        self.with_distance(posed, estimate)
    }

    /// The problem with a distance found before, and its error bound.
    pub(super) fn with_distance(
        &self,
        posed: &Posed<D>,
        [distance, distance_error]: [f64; 2],
    ) -> Result<Known<&AnyBounded<'m, D>, D>, VerifyError> {
        Ok(Known { metric: &self.metric, ends: posed.ends()?, distance, distance_error })
    }

    /// Two points with the distance that the metric knows, as in [`Known::between`].
    pub(super) fn exact(
        &self,
        [a, b]: [SVector<f64, D>; 2],
        ends: Ends<D>,
        distance: f64,
    ) -> Known<&AnyBounded<'m, D>, D> {
        let metric = &self.metric;
        let size = (a.norm() + b.norm()) * metric.constants().c2().sqrt();
        Known { metric, ends, distance, distance_error: 16.0 * f64::EPSILON * size }
    }
}

/// The problem with a distance extrapolated from a fine grid, see [`Case::known`].
pub(super) fn estimated<M: Bounded<D>, const D: usize>(
    metric: M,
    ends: Ends<D>,
    shorter: &[Reconstruction<D>],
) -> Result<Known<M, D>, VerifyError> {
    let starts = match shorter {
        [] => Starts::Automatic,
        _ => Starts::Also(shorter.iter().map(|seen| seen.minimum.sequence.clone()).collect()),
    };
    let options = Options { starts, ..Options::default() };
    let minimum = minimise(&metric, &ends, Trapezoidal, REFERENCE, &options)?;
    let unknown = VerifyError::NotConverged {
        n: REFERENCE,
        stop: minimum.stop,
        curvature: minimum.curvature,
    };
    let Some(estimate) = extrapolate(&minimum.levels, 2) else { return Err(unknown) };
    if !(estimate.value > 0.0) {
        return Err(unknown);
    }
    let distance = estimate.value.sqrt();
    let error = 10.0 * estimate.error + 1e-13 * estimate.value;
    Ok(Known { metric, ends, distance, distance_error: error / (2.0 * distance) })
}
