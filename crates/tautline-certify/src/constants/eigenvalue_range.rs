//! `c₁` and `c₂`: the least and the greatest eigenvalue of `H`.

use nalgebra::{DMatrix, DVector, SVector};
use tautline_scalar::Interval;

use super::{
    eigenvalue_bound::eigen,
    gram::{At, Gram},
    lifted::Variable,
    spectral::{Spectral, form, square},
};
use crate::patch::Point;

/// Which eigenvalue is wanted.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum End {
    Least,
    Greatest,
}

/// The greatest eigenvalue of `H(x)`, which is at most `c₂`; or `−λ` for the least eigenvalue `λ`,
/// which is at most `−c₁`.
pub(super) struct Eigenvalue<'a, const D: usize>(pub(super) Gram<'a, D>, pub(super) End);

impl<const D: usize> Spectral<D> for Eigenvalue<'_, D> {
    type Choice = ();

    fn gram(&self) -> Gram<'_, D> {
        self.0
    }

    fn choice(&self, _: &Point) {}

    fn matrices<T: Variable>(&self, at: At<'_, T, D>, _: &()) -> Vec<DMatrix<T>> {
        let h = block(self.0, at);
        vec![if self.1 == End::Least { h.map(|entry| -entry) } else { h }]
    }

    fn wanted(&self, at: At<'_, f64, D>) -> f64 {
        eigen(&block(self.0, at)).map_or(f64::NAN, |eigen| match self.1 {
            End::Least => -eigen.eigenvalues.min(),
            End::Greatest => eigen.eigenvalues.max(),
        })
    }

    /// Returns an upper bound on the least eigenvalue itself, or a lower bound on the greatest.
    fn witness(&self, x: &SVector<f64, D>) -> f64 {
        match self.1 {
            End::Least => quotient(self.0, x, |eigenvalues| eigenvalues.imin()).hi(),
            End::Greatest => quotient(self.0, x, |eigenvalues| eigenvalues.imax()).lo(),
        }
    }

    /// Also true if the least eigenvalue is certainly not positive.
    fn is_refuted(&self, x: &Point, value: f64) -> bool {
        let is_indefinite =
            || self.1 == End::Least && value >= 0.0 && self.witness(&self.in_space(x)) <= 0.0;
        is_indefinite() || (value.is_nan() && self.0.is_undefined(&self.in_space(x)))
    }
}

/// Returns `H(x)`, or `φ(x)` alone if `H = φ I`.
fn block<T: Variable, const D: usize>(gram: Gram<'_, D>, at: At<'_, T, D>) -> DMatrix<T> {
    let h = gram.at(at);
    if gram.isotropic { h.view((0, 0), (1, 1)).into_owned() } else { h }
}

/// Encloses the Rayleigh quotient `uᵀHu / uᵀu` for `u`, an eigenvector up to rounding. For any `u`
/// the quotient lies between the least and the greatest eigenvalue.
fn quotient<const D: usize>(
    gram: Gram<'_, D>,
    x: &SVector<f64, D>,
    which: impl Fn(&DVector<f64>) -> usize,
) -> Interval {
    let Some(eigen) = eigen(&gram.at(At::Space(x))) else { return Interval::UNDEFINED };
    let vector = eigen.eigenvectors.column(which(&eigen.eigenvalues));
    let u = SVector::<f64, D>::from_fn(|i, _| vector[i]);
    let h = gram.at(At::Space(&x.map(Interval::point)));
    form(|i, j| h[(i, j)], &u) / square(&u)
}
