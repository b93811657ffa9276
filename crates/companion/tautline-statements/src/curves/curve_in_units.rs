//! `CurveInUnits`: a curve in another unit of coordinates.

use super::{BoundedCurve, Curve, Motion};
use crate::Units;

/// `ℓ γ`: the same curve with coordinates multiplied by `ell`. Time has no unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveInUnits<C> {
    curve: C,
    ell: f64,
}

impl Units {
    /// Returns a curve in these units.
    pub fn curve<C>(self, curve: C) -> CurveInUnits<C> {
        CurveInUnits { curve, ell: self.ell }
    }
}

impl<const D: usize, C: Curve<D>> Curve<D> for CurveInUnits<C> {
    fn motion(&self, t: f64) -> Motion<D> {
        self.curve.motion(t).scaled(self.ell)
    }

    fn corners(&self) -> Vec<f64> {
        self.curve.corners()
    }
}

impl<const D: usize, C: BoundedCurve<D>> BoundedCurve<D> for CurveInUnits<C> {
    fn suprema(&self) -> [f64; 3] {
        self.curve.suprema().map(|bound| bound * self.ell)
    }
}
