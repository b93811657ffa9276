//! `Hamiltonian`: `K(x, p) = ½ pᵀH(x)⁻¹p` and its derivatives.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::Jet2;

/// The derivatives of `K(x, p) = ½ pᵀH(x)⁻¹p` at one place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hamiltonian<const D: usize> {
    /// `H`.
    pub(crate) h: SMatrix<f64, D, D>,
    /// `K_p = H⁻¹p`, the velocity.
    pub(crate) velocity: SVector<f64, D>,
    /// `−K_x`, the force.
    pub(crate) force: SVector<f64, D>,
    /// `K_xx`.
    pub(crate) xx: SMatrix<f64, D, D>,
    /// `K_xp`, with a row for each coordinate of `x`.
    pub(crate) xp: SMatrix<f64, D, D>,
    /// `K_pp = H⁻¹`.
    pub(crate) pp: SMatrix<f64, D, D>,
}

impl<const D: usize> Hamiltonian<D> {
    /// Returns the derivatives; `None` if `H` cannot be inverted.
    ///
    /// With `v = H⁻¹p`: `∂ₖK = −½ vᵀ∂ₖH v`, `∂ₖv = −H⁻¹ ∂ₖH v`, and
    /// `∂ₖ∂ₗK = (∂ₖH v)ᵀH⁻¹(∂ₗH v) − ½ vᵀ∂ₖ∂ₗH v`.
    pub(crate) fn at(
        formula: &Formula<D>,
        x: &SVector<f64, D>,
        p: &SVector<f64, D>,
    ) -> Option<Self> {
        let coordinates: [f64; D] = std::array::from_fn(|i| x[i]);
        let jets = formula.gram(&SVector::from(Jet2::variables(&coordinates)));
        let entry = |i: usize, j: usize| &jets[(i.min(j), i.max(j))];
        let h = SMatrix::<f64, D, D>::from_fn(|i, j| entry(i, j).value());
        let pp: SMatrix<f64, D, D> = h.cholesky()?.inverse();
        let velocity: SVector<f64, D> = pp * p;
        // The column k is ∂ₖH v.
        let turned = SMatrix::<f64, D, D>::from_fn(|i, k| {
            (0..D).map(|j| entry(i, j).first(k) * velocity[j]).sum()
        });
        let bent = SMatrix::<f64, D, D>::from_fn(|k, l| {
            let terms = (0..D * D).map(|at| (at / D, at % D));
            terms.map(|(i, j)| velocity[i] * entry(i, j).second(k, l) * velocity[j]).sum()
        });
        Some(Self {
            h,
            velocity,
            force: turned.transpose() * velocity * 0.5,
            xx: turned.transpose() * pp * turned - bent * 0.5,
            xp: -turned.transpose() * pp,
            pp,
        })
    }
}

/// Returns the eigenvalues of a symmetric matrix.
pub(crate) fn eigenvalues<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Vec<f64> {
    // nalgebra finds eigenvalues of matrices whose dimension is known or dynamic, not a parameter.
    let matrix = nalgebra::DMatrix::from_fn(D, D, |i, j| matrix[(i, j)]);
    matrix.symmetric_eigenvalues().iter().copied().collect()
}
