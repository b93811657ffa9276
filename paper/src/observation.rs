//! `Observation`: the measurements of one computed minimiser.

use tautline::{Curvature, Integral};

/// The numbers of one solve, for one case, one rule and one `N`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Observation {
    /// The number of subintervals.
    pub(crate) n: usize,
    /// The discrete energy, in `m²`.
    pub(crate) discrete_energy: f64,
    /// The energy `E(γᵖˡ)` of the curve, in `m²`.
    pub(crate) energy: Integral,
    /// The squared length `L(γᵖˡ)²` of the curve, in `m²`.
    pub(crate) length_squared: Integral,
    /// The relative decrement of the last Newton step.
    pub(crate) decrement: f64,
    /// The relative residual of the discrete geodesic equation.
    pub(crate) residual: f64,
    /// The predicted rounding error of the residual.
    pub(crate) residual_floor: f64,
    /// The signature of the Hessian.
    pub(crate) curvature: Curvature,
}
