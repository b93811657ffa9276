//! `CurveInUnits`: a curve whose coordinates are measured in another unit.

use nalgebra::SVector;

use super::Curve;
use crate::Units;

/// `ℓ γ`: the same curve where what was 1 in coordinates is `ell`. Time has no unit.
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
    fn jet(&self, t: f64) -> [SVector<f64, D>; 3] {
        self.curve.jet(t).map(|derivative| derivative * self.ell)
    }

    fn suprema(&self) -> [f64; 3] {
        self.curve.suprema().map(|bound| bound * self.ell)
    }

    fn kinks(&self) -> &[f64] {
        self.curve.kinks()
    }

    fn largest_jump(&self) -> f64 {
        self.curve.largest_jump() * self.ell
    }
}
