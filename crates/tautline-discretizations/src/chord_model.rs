//! `ChordModel`: what one chord adds to a discrete energy, to second order.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;

use crate::{Node, Rule, contraction::Contraction};

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
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node.
    pub is_metric: bool,
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
        let node = |node: &Node| Self::at_node(metric, x, d, node.fraction, node.weight * n);
        let [first, rest @ ..] = R::NODES else { return Self::zero() };
        rest.iter().map(node).fold(node(first), Self::plus)
    }

    /// The part of one node, of the weight `w`, at the fraction `far` of the chord.
    #[inline(always)]
    fn at_node(
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        d: &SVector<f64, D>,
        far: f64,
        w: f64,
    ) -> Self {
        let near = 1.0 - far;
        let Contraction { h, g, p, q, is_metric } = Contraction::new(metric, &(x + d * far), d);
        // Each with its weight, and twice where twice is wanted.
        let (h, g, p, q) = (h * (2.0 * w), g * w, p * (2.0 * w), q * w);
        let (hd, transposed) = (h * d, p.transpose());
        let symmetric = p + transposed;
        Self {
            energy: 0.5 * d.dot(&hd),
            trace: 0.5 * h.trace(),
            gradient: [g * near - hd, g * far + hd],
            hessian: [
                h - symmetric * near + q * (near * near),
                h + symmetric * far + q * (far * far),
            ],
            coupling: q * (near * far) - h - p * far + transposed * near,
            is_metric,
        }
    }

    /// The sum of two parts.
    fn plus(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            trace: self.trace + other.trace,
            gradient: [0, 1].map(|end| self.gradient[end] + other.gradient[end]),
            hessian: [0, 1].map(|end| self.hessian[end] + other.hessian[end]),
            coupling: self.coupling + other.coupling,
            is_metric: self.is_metric && other.is_metric,
        }
    }

    /// What a rule without nodes has.
    fn zero() -> Self {
        Self {
            energy: 0.0,
            trace: 0.0,
            gradient: [SVector::zeros(); 2],
            hessian: [SMatrix::zeros(); 2],
            coupling: SMatrix::zeros(),
            is_metric: true,
        }
    }
}
