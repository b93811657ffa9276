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

/// Returns the eigenvalues of a symmetric matrix; NaN if it is not finite.
pub(crate) fn eigenvalues<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Vec<f64> {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        // The iteration would not end.
        return vec![f64::NAN; D];
    }
    // nalgebra finds eigenvalues of matrices whose dimension is known or dynamic, not a parameter.
    let matrix = nalgebra::DMatrix::from_fn(D, D, |i, j| matrix[(i, j)]);
    matrix.symmetric_eigenvalues().iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_formula::Formula;

    use super::{Hamiltonian, eigenvalues};

    /// Central differences of the first derivatives, which are those of `½ pᵀH⁻¹p`.
    #[test]
    fn the_second_derivatives_are_differences_of_the_first() {
        let text = "pullback(x1 + 0.6*sin(2*x2), x2 + 0.3*x1*x2)";
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        let (x, p) = (vector![0.3, -0.4], vector![0.7, 1.1]);
        let at = |x, p| Hamiltonian::at(&formula, &x, &p).expect("invertible");
        let (here, h) = (at(x, p), 1e-5);
        for k in 0..2 {
            let step = SVector::from_fn(|i, _| if i == k { h } else { 0.0 });
            let energy = |x, p: SVector<f64, 2>| 0.5 * p.dot(&at(x, p).velocity);
            let slope = (energy(x + step, p) - energy(x - step, p)) / (2.0 * h);
            assert!((here.force[k] + slope).abs() < 1e-9, "{} {slope}", here.force[k]);
            let (ahead, behind) = (at(x + step, p), at(x - step, p));
            let xx = (behind.force - ahead.force) / (2.0 * h);
            let xp = (ahead.velocity - behind.velocity) / (2.0 * h);
            for l in 0..2 {
                assert!((here.xx[(k, l)] - xx[l]).abs() < 1e-8, "{} {xx}", here.xx);
                assert!((here.xp[(k, l)] - xp[l]).abs() < 1e-8, "{} {xp}", here.xp);
            }
        }
        assert!((here.pp * here.h)[(0, 1)].abs() < 1e-14);
    }

    #[test]
    fn eigenvalues_are_those_of_the_matrix() {
        let mut found = eigenvalues(&nalgebra::matrix![2.0, 1.0; 1.0, 2.0]);
        found.sort_by(f64::total_cmp);
        assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 3.0).abs() < 1e-14, "{found:?}");
        let found = eigenvalues(&nalgebra::matrix![2.0, f64::NAN; f64::NAN, 2.0]);
        assert!(found.len() == 2 && found.iter().all(|value| value.is_nan()), "{found:?}");
    }
}
