//! Section 4: minimal curves are minimal geodesics reparametrised by a clock, and minimal curves of
//! constant speed are geodesics.

pub(crate) mod clocks;
pub(crate) mod constant_speed;
pub(crate) mod normal_balls;

use nalgebra::SVector;
use tautline_statements::Known;

/// Returns the two points of a problem between points.
fn ends<M, const D: usize>(known: &Known<M, D>) -> [SVector<f64, D>; 2] {
    [known.ends.first(), known.ends.second()].map(|set| set.project(&SVector::zeros()))
}
