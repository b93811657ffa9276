//! `Stationarity`: how close a point sequence is to a discrete minimiser.

use tautline_discretizations::PointSequence;

use crate::newton::{magnitude::Magnitude, rounding::negligible};

/// What the first derivatives and a factorisation of the Hessian reveal about a point sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stationarity {
    pub(crate) magnitude: Magnitude,
    /// Whether the metric is positive definite at every node.
    pub(crate) is_metric: bool,
    /// The decrease of the energy that a Newton step predicts, half the square of the Newton
    /// decrement, in `m²`.
    pub(crate) decrement: f64,
    /// The [residual](crate::Minimum::residual).
    pub(crate) residual: f64,
    /// The residual that rounding alone causes.
    pub(crate) residual_floor: f64,
}

impl Stationarity {
    /// Returns whether the energy cannot be lowered in `f64`.
    pub(crate) fn is_reached<const D: usize>(&self, sequence: &PointSequence<D>) -> bool {
        self.decrement <= negligible(self.magnitude, sequence)
    }
}
