//! The energy of a curve under a metric.

use tautline::{Integral, Metric, quadrature::integrate};

use super::Curve;

/// Returns `E(γ) = ∫₀¹ γ̇ᵀ H(γ) γ̇ dt`, in `m²`, with the error of the quadrature.
///
/// The quadrature splits `[0, 1]` at the kinks of the curve and into `pieces` equal intervals, so
/// that kinks of the metric at multiples of `1/pieces` do not lie inside an interval.
pub fn curve_energy<const D: usize>(
    metric: &impl Metric<D>,
    curve: &impl Curve<D>,
    pieces: usize,
) -> Integral {
    let square = |t: f64| curve.motion(t).speed_squared(metric);
    let grid = (1..pieces.max(1)).map(|k| k as f64 / pieces as f64);
    let mut ends: Vec<f64> = grid.chain(curve.corners()).chain([1.0]).collect();
    ends.sort_by(f64::total_cmp);
    let mut energy = Integral::default();
    let mut from = 0.0;
    for to in ends {
        energy += integrate(square, from, to, 1e-13);
        from = to;
    }
    energy
}
