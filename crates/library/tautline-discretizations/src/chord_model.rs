//! `ChordModel`: the contribution of one chord to a discrete energy, to second order.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Scalar;

/// The energy of one chord, with its first and second derivatives with respect to the two points
/// that it joins. For pairs of numbers it is the model of two chords side by side. A
/// [`ChordBatch`](crate::ChordBatch) computes it.
///
/// Derivation: take one node of weight 1 at the fraction `θ` of the chord `d = y − x`, with `H` and
/// its derivatives evaluated at `x + θ d`, and the energy `e = N dᵀHd`. Then
///
/// ```text
/// q = H d,   Gₖ = dᵀ ∂ₖH d,   Pᵢₖ = (∂ₖH d)ᵢ,   Qₖₗ = dᵀ ∂ₖ∂ₗH d
/// ∂e/∂x = N (−2q + (1−θ) G),                  ∂e/∂y = N (2q + θ G)
/// ∂²e/∂x² = N (2H − 2(1−θ)(P + Pᵀ) + (1−θ)² Q),  ∂²e/∂y² = N (2H + 2θ(P + Pᵀ) + θ² Q)
/// ∂²e/∂x∂y = N (−2H − 2θ P + 2(1−θ) Pᵀ + θ(1−θ) Q)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordModel<const D: usize, T = f64> {
    /// The energy, in `m²`.
    pub energy: T,
    /// `N tr H`, averaged over the nodes, in `m²/ℓ²`.
    pub trace: T,
    /// The gradients with respect to the near and the far point, in `m²/ℓ`.
    pub gradient: [SVector<T, D>; 2],
    /// The second derivatives with respect to the near and the far point, in `m²/ℓ²`.
    pub hessian: [SMatrix<T, D, D>; 2],
    /// The mixed second derivatives, with a row for each coordinate of the near point and a column
    /// for each coordinate of the far point.
    pub coupling: SMatrix<T, D, D>,
}

impl<T: Scalar, const D: usize> ChordModel<D, T> {
    /// Returns the model of a rule without nodes, which is zero.
    #[inline(always)]
    pub(crate) fn zero() -> Self {
        Self {
            energy: T::zero(),
            trace: T::zero(),
            gradient: [SVector::zeros(); 2],
            hessian: [SMatrix::zeros(); 2],
            coupling: SMatrix::zeros(),
        }
    }

    /// Adds the contribution of another node.
    #[inline(always)]
    pub(crate) fn add(&mut self, other: &Self) {
        self.energy += other.energy;
        self.trace += other.trace;
        for end in 0..2 {
            self.gradient[end] += other.gradient[end];
            self.hessian[end] += other.hessian[end];
        }
        self.coupling += other.coupling;
    }
}
