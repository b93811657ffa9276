//! Sets as they are read and written with the feature `serde`. What is read goes through the
//! constructors, which check it.

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use crate::SetError;

/// The fields of a [`Point`](crate::Point).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Point<const D: usize> {
    position: SVector<f64, D>,
}

impl<const D: usize> TryFrom<Point<D>> for crate::Point<D> {
    type Error = SetError;

    fn try_from(Point { position }: Point<D>) -> Result<Self, SetError> {
        Self::new(position)
    }
}

/// The fields of a [`Ball`](crate::Ball).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Ball<const D: usize> {
    centre: SVector<f64, D>,
    r: f64,
}

impl<const D: usize> TryFrom<Ball<D>> for crate::Ball<D> {
    type Error = SetError;

    fn try_from(Ball { centre, r }: Ball<D>) -> Result<Self, SetError> {
        Self::new(centre, r)
    }
}

/// The fields of an [`AxisBox`](crate::AxisBox).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AxisBox<const D: usize> {
    lower: SVector<f64, D>,
    upper: SVector<f64, D>,
}

impl<const D: usize> TryFrom<AxisBox<D>> for crate::AxisBox<D> {
    type Error = SetError;

    fn try_from(AxisBox { lower, upper }: AxisBox<D>) -> Result<Self, SetError> {
        Self::from_corners(lower, upper)
    }
}

/// A [`HalfSpace`](crate::HalfSpace) by the numbers that were given for it, which define it exactly.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct HalfSpace<const D: usize> {
    normal: SVector<f64, D>,
    offset: f64,
}

impl<const D: usize> TryFrom<HalfSpace<D>> for crate::HalfSpace<D> {
    type Error = SetError;

    fn try_from(HalfSpace { normal, offset }: HalfSpace<D>) -> Result<Self, SetError> {
        Self::new(normal, offset)
    }
}

impl<const D: usize> From<crate::HalfSpace<D>> for HalfSpace<D> {
    fn from(half_space: crate::HalfSpace<D>) -> Self {
        let (&normal, offset) = half_space.given();
        Self { normal, offset }
    }
}
