//! Problems in a region, between pairs of sets of every kind.

use nalgebra::SVector;
use proptest::prelude::*;
use tautline::{AxisBox, Ball, Ends, FiniteSet, HalfSpace, Point, SetError};

use crate::Region;

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

/// Two sets near `a` and `b`, apart from each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Posed<const D: usize> {
    kind: Kind,
    a: SVector<f64, D>,
    b: SVector<f64, D>,
    further: SVector<f64, D>,
}

impl<const D: usize> Posed<D> {
    /// Draws problems of one kind, with `a` and `b` at least an eighth of the longest edge apart.
    /// The points are drawn at random, never placed on an axis of symmetry, because the critical
    /// point found between two points on such an axis may be a saddle.
    pub(super) fn problems(kind: Kind, region: &Region<D>) -> impl Strategy<Value = Self> + use<D> {
        let apart = region.size() / 8.0;
        (region.uniform(), region.uniform(), region.uniform())
            .prop_filter("the sets are apart", move |(a, b, further)| {
                (b - a).norm() >= apart && (further - a).norm() >= apart
            })
            .prop_map(move |(a, b, further)| Self { kind, a, b, further })
    }

    /// Returns the problem between two points.
    pub(super) fn between(a: SVector<f64, D>, b: SVector<f64, D>) -> Self {
        Self { kind: Kind::Points, a, b, further: b }
    }

    /// Returns the two sets. Their radii, or half the diagonals of boxes, are a quarter of
    /// `|b − a|`.
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
                // `further` may lie in the box and then have distance 0, so the second point
                // mirrors `b` instead.
                let mirrored = a * 2.0 - b;
                Ends::new(FiniteSet::new([a, mirrored])?, AxisBox::new(b, half)?)
            }
        }
    }

    /// Returns the two sets near these members, with a finite set replaced by its member.
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

    /// Returns a third point, at least an eighth of the longest edge away from `a`.
    pub(super) fn further(&self) -> SVector<f64, D> {
        self.further
    }

    /// Returns the two points, if both sets are points.
    pub(super) fn points(&self) -> Option<[SVector<f64, D>; 2]> {
        (self.kind == Kind::Points).then_some([self.a, self.b])
    }
}
