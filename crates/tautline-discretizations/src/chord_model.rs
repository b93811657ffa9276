//! `ChordModel`: what one chord adds to a discrete energy, to second order.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{Rule, contraction::Contraction};

/// The part of one chord in a discrete energy, with its first and second derivatives by the two
/// points that it joins.
///
/// Derivation, for one node of weight 1 at the fraction `θ` of the chord `d = y − x`, with
/// `H` and its derivatives at `x + θ d`, and `e = N dᵀHd` its part of the energy:
///
/// ```text
/// q = H d,   Gₖ = dᵀ ∂ₖH d,   Pᵢₖ = (∂ₖH d)ᵢ,   Qₖₗ = dᵀ ∂ₖ∂ₗH d
/// ∂e/∂x = N (−2q + (1−θ) G),                  ∂e/∂y = N (2q + θ G)
/// ∂²e/∂x² = N (2H − 2(1−θ)(P + Pᵀ) + (1−θ)² Q),  ∂²e/∂y² = N (2H + 2θ(P + Pᵀ) + θ² Q)
/// ∂²e/∂x∂y = N (−2H − 2θ P + 2(1−θ) Pᵀ + θ(1−θ) Q)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordModel<const D: usize> {
    /// The part of the energy, in `m²`.
    pub energy: f64,
    /// `N tr H`, the mean over the nodes, in `m²/ℓ²`.
    pub trace: f64,
    /// The gradients by the near and by the far point, in `m²/ℓ`.
    pub gradient: [SVector<f64, D>; 2],
    /// The second derivatives by the near and by the far point, in `m²/ℓ²`.
    pub hessian: [SMatrix<f64, D, D>; 2],
    /// The mixed ones: rows by the near point, columns by the far.
    pub coupling: SMatrix<f64, D, D>,
}

impl<const D: usize> ChordModel<D> {
    /// Expands the part that the chord from `x` to `x + d` has in the energy of `rule` with `n`
    /// subintervals. NaN where the metric is.
    #[inline(always)]
    #[must_use]
    pub fn new<R: Rule>(
        _rule: R,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        d: &SVector<f64, D>,
        n: f64,
    ) -> Self {
        let mut chord = Self {
            energy: 0.0,
            trace: 0.0,
            gradient: [SVector::zeros(); 2],
            hessian: [SMatrix::zeros(); 2],
            coupling: SMatrix::zeros(),
        };
        for node in R::NODES {
            let (w, near, far) = (node.weight * n, 1.0 - node.fraction, node.fraction);
            let Contraction { h, g, p, q } = Contraction::new(metric, &(x + d * far), d);
            let hd = h * d;
            chord.energy += w * d.dot(&hd);
            chord.trace += w * h.trace();
            chord.gradient[0] += (g * near - hd * 2.0) * w;
            chord.gradient[1] += (g * far + hd * 2.0) * w;
            let symmetric = p + p.transpose();
            chord.hessian[0] += (h * 2.0 - symmetric * (2.0 * near) + q * (near * near)) * w;
            chord.hessian[1] += (h * 2.0 + symmetric * (2.0 * far) + q * (far * far)) * w;
            chord.coupling +=
                (q * (near * far) - h * 2.0 - p * (2.0 * far) + p.transpose() * (2.0 * near)) * w;
        }
        chord
    }
}
