//! Section 4: minimal curves are minimal geodesics run through by a clock, and minimal curves of
//! constant speed are geodesics.

mod clocks;
mod constant_speed;
mod normal_balls;

use nalgebra::SVector;
use tautline_statements::{
    Known,
    curves::{Curve, Motion},
};

use super::Check;

pub(super) fn checks() -> Vec<Check> {
    let parts = [clocks::checks(), normal_balls::checks(), constant_speed::checks()];
    parts.into_iter().flatten().collect()
}

/// The segment `a + t (b − a)`, at constant speed in coordinates.
struct Segment<const D: usize>([SVector<f64, D>; 2]);

impl<const D: usize> Curve<D> for Segment<D> {
    fn motion(&self, t: f64) -> Motion<D> {
        let [a, b] = self.0;
        let acceleration = SVector::zeros();
        Motion { position: a + (b - a) * t, velocity: b - a, acceleration }
    }
}

/// The two points of a problem between points.
fn ends<M, const D: usize>(known: &Known<M, D>) -> [SVector<f64, D>; 2] {
    let origin = SVector::zeros();
    [known.ends.first().project(&origin), known.ends.second().project(&origin)]
}
