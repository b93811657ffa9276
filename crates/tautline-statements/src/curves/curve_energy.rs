//! The energy of a curve under a metric.

use tautline::{Integral, Metric, norm_squared, quadrature::integrate};

use super::{Curve, Motion};

/// Returns `E(γ) = ∫₀¹ γ̇ᵀ H(γ) γ̇ dt`, in `m²`, with the error of the quadrature.
///
/// Piece by piece from kink to kink, and over `pieces` equal intervals: where the metric itself has
/// kinks that the curve meets at multiples of `1/pieces`, none is inside.
pub fn curve_energy<const D: usize>(
    metric: &impl Metric<D>,
    curve: &impl Curve<D>,
    pieces: usize,
) -> Integral {
    let speed = |t: f64| {
        let Motion { position, velocity, .. } = curve.motion(t);
        norm_squared(metric, &position, &velocity)
    };
    let grid = (1..pieces.max(1)).map(|k| k as f64 / pieces as f64);
    let mut ends: Vec<f64> = grid.chain(curve.corners()).chain([1.0]).collect();
    ends.sort_by(f64::total_cmp);
    let mut energy = Integral::default();
    let mut from = 0.0;
    for to in ends {
        energy += integrate(speed, from, to, 1e-13);
        from = to;
    }
    energy
}
