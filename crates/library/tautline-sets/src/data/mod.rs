//! Sets as they are read and written with the feature `serde`. What is read goes through the
//! constructors, which check it.

use serde::{Deserialize, Serialize};

use crate::SetError;

/// The fields of a [`Point`](crate::Point).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Point {
    position: Vec<f64>,
}

impl<const D: usize> TryFrom<Point> for crate::Point<D> {
    type Error = SetError;

    fn try_from(Point { position }: Point) -> Result<Self, SetError> {
        Self::from_slice(&position)
    }
}

/// The fields of a [`FiniteSet`](crate::FiniteSet).
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FiniteSet {
    points: Vec<Vec<f64>>,
}

impl<const D: usize> TryFrom<FiniteSet> for crate::FiniteSet<D> {
    type Error = SetError;

    fn try_from(FiniteSet { points }: FiniteSet) -> Result<Self, SetError> {
        Self::from_slices(&points)
    }
}

impl<const D: usize> From<crate::FiniteSet<D>> for FiniteSet {
    fn from(set: crate::FiniteSet<D>) -> Self {
        Self { points: set.points().iter().map(|point| point.position_slice().to_vec()).collect() }
    }
}

/// The fields of a [`Ball`](crate::Ball) or a [`Sphere`](crate::Sphere).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Ball {
    centre: Vec<f64>,
    r: f64,
}

impl<const D: usize> TryFrom<Ball> for crate::Ball<D> {
    type Error = SetError;

    fn try_from(Ball { centre, r }: Ball) -> Result<Self, SetError> {
        Self::from_slice(&centre, r)
    }
}

impl<const D: usize> TryFrom<Ball> for crate::Sphere<D> {
    type Error = SetError;

    fn try_from(Ball { centre, r }: Ball) -> Result<Self, SetError> {
        Self::from_slice(&centre, r)
    }
}

/// The fields of an [`AxisBox`](crate::AxisBox).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AxisBox {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl<const D: usize> TryFrom<AxisBox> for crate::AxisBox<D> {
    type Error = SetError;

    fn try_from(AxisBox { lower, upper }: AxisBox) -> Result<Self, SetError> {
        Self::from_slices(&lower, &upper)
    }
}

/// A [`Segment`](crate::Segment) by its ends.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Segment {
    start: Vec<f64>,
    end: Vec<f64>,
}

impl<const D: usize> TryFrom<Segment> for crate::Segment<D> {
    type Error = SetError;

    fn try_from(Segment { start, end }: Segment) -> Result<Self, SetError> {
        Self::from_slices(&start, &end)
    }
}

impl<const D: usize> From<crate::Segment<D>> for Segment {
    fn from(segment: crate::Segment<D>) -> Self {
        let [start, end] = segment.end_slices().map(<[f64]>::to_vec);
        Self { start, end }
    }
}

/// A [`HalfSpace`](crate::HalfSpace) by the numbers that were given for it, which define it exactly.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct HalfSpace {
    normal: Vec<f64>,
    offset: f64,
}

impl<const D: usize> TryFrom<HalfSpace> for crate::HalfSpace<D> {
    type Error = SetError;

    fn try_from(HalfSpace { normal, offset }: HalfSpace) -> Result<Self, SetError> {
        Self::from_slice(&normal, offset)
    }
}

impl<const D: usize> From<crate::HalfSpace<D>> for HalfSpace {
    fn from(half_space: crate::HalfSpace<D>) -> Self {
        let (normal, offset) = half_space.given_slice();
        Self { normal: normal.to_vec(), offset }
    }
}

/// An [`AffineSubspace`](crate::AffineSubspace) by the vectors that were given for it, which define it
/// exactly.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AffineSubspace {
    base: Vec<f64>,
    directions: Vec<Vec<f64>>,
}

impl<const D: usize> TryFrom<AffineSubspace> for crate::AffineSubspace<D> {
    type Error = SetError;

    fn try_from(AffineSubspace { base, directions }: AffineSubspace) -> Result<Self, SetError> {
        Self::from_slices(&base, &directions)
    }
}

impl<const D: usize> From<crate::AffineSubspace<D>> for AffineSubspace {
    fn from(subspace: crate::AffineSubspace<D>) -> Self {
        let directions = subspace.given_slices().iter().map(|v| v.to_vec()).collect();
        Self { base: subspace.base_slice().to_vec(), directions }
    }
}
