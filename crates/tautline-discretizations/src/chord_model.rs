//! `ChordModel`: what one chord adds to a discrete energy, to second order.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Scalar;

use crate::Node;

/// The part of one chord in a discrete energy, with its first and second derivatives by the two
/// points that it joins.
///
/// With pairs of numbers, those of two chords side by side. Made by a [`ChordBatch`](crate::ChordBatch).
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
pub struct ChordModel<const D: usize, T = f64> {
    /// The part of the energy, in `m²`.
    pub energy: T,
    /// `N tr H`, the mean over the nodes, in `m²/ℓ²`.
    pub trace: T,
    /// The gradients by the near and by the far point, in `m²/ℓ`.
    pub gradient: [SVector<T, D>; 2],
    /// The second derivatives by the near and by the far point, in `m²/ℓ²`.
    pub hessian: [SMatrix<T, D, D>; 2],
    /// The mixed ones: rows by the near point, columns by the far.
    pub coupling: SMatrix<T, D, D>,
}

/// The derivatives of `H` at a place, contracted with a chord `d`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contraction<const D: usize, T> {
    /// `H`.
    pub(crate) h: SMatrix<T, D, D>,
    /// `Gₖ = dᵀ ∂ₖH d`.
    pub(crate) g: SVector<T, D>,
    /// `Pᵢₖ = (∂ₖH d)ᵢ`.
    pub(crate) p: SMatrix<T, D, D>,
    /// `Qₖₗ = dᵀ ∂ₖ∂ₗH d`.
    pub(crate) q: SMatrix<T, D, D>,
}

impl<T: Scalar, const D: usize> ChordModel<D, T> {
    /// The sum over the nodes, of which each has its number.
    #[inline(always)]
    pub(crate) fn over(nodes: &[Node], node: impl Fn(usize, &Node) -> Self) -> Self {
        let [first, rest @ ..] = nodes else { return Self::zero() };
        let mut sum = node(0, first);
        for (place, next) in rest.iter().enumerate() {
            sum = sum.plus(node(place + 1, next));
        }
        sum
    }

    /// The part of one node, of the weight `w`, at the fraction `far` of the chord.
    #[inline(always)]
    pub(crate) fn at_node(
        contraction: Contraction<D, T>,
        d: &SVector<T, D>,
        far: T,
        w: f64,
    ) -> Self {
        let near = T::one() - far;
        let Contraction { h, g, p, q } = contraction;
        // Each with its weight, and twice where twice is wanted.
        let (once, twice) = (T::constant(w), T::constant(2.0 * w));
        let (h, g, p, q) = (h * twice, g * once, p * twice, q * once);
        let (hd, transposed) = (h * d, p.transpose());
        let symmetric = p + transposed;
        Self {
            energy: d.dot(&hd) * 0.5,
            trace: h.trace() * 0.5,
            gradient: [g * near - hd, g * far + hd],
            hessian: [
                h - symmetric * near + q * (near * near),
                h + symmetric * far + q * (far * far),
            ],
            coupling: q * (near * far) - h - p * far + transposed * near,
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
        }
    }

    /// What a rule without nodes has.
    fn zero() -> Self {
        Self {
            energy: T::zero(),
            trace: T::zero(),
            gradient: [SVector::zeros(); 2],
            hessian: [SMatrix::zeros(); 2],
            coupling: SMatrix::zeros(),
        }
    }
}
