//! `c₁` and `c₂`: the least and the greatest eigenvalue of `H`.

use nalgebra::{DMatrix, DVector};
use tautline_scalar::Interval;

use super::{
    eigenvalue_bound::eigen,
    gram::{At, Gram, points},
    lifted::Variable,
    rows::Order,
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
pub(super) struct Eigenvalue<'a>(pub(super) Gram<'a>, pub(super) End);

impl Spectral for Eigenvalue<'_> {
    type Choice = ();

    fn gram(&self) -> Gram<'_> {
        self.0
    }

    fn choice(&self, _: &Point) {}

    fn matrices<T: Variable>(&self, at: At<'_, T>, _: &()) -> Vec<DMatrix<T>> {
        let h = block(self.0, at);
        vec![if self.1 == End::Least { h.map(|entry| -entry) } else { h }]
    }

    fn wanted(&self, at: At<'_, f64>) -> f64 {
        eigen(&block(self.0, at)).map_or(f64::NAN, |eigen| match self.1 {
            End::Least => -eigen.eigenvalues.min(),
            End::Greatest => eigen.eigenvalues.max(),
        })
    }

    /// Returns an upper bound on the least eigenvalue itself, or a lower bound on the greatest.
    fn witness(&self, x: &[f64]) -> f64 {
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
fn block<T: Variable>(gram: Gram<'_>, at: At<'_, T>) -> DMatrix<T> {
    let h = gram.expansion(at, Order::Value);
    let n = if gram.isotropic { 1 } else { gram.dimension() };
    DMatrix::from_fn(n, n, |i, j| h.value(i, j))
}

/// Encloses the Rayleigh quotient `uᵀHu / uᵀu` for `u`, an eigenvector up to rounding. For any `u`
/// the quotient lies between the least and the greatest eigenvalue.
fn quotient(gram: Gram<'_>, x: &[f64], which: impl Fn(&DVector<f64>) -> usize) -> Interval {
    let (h, d) = (gram.expansion(At::Space(x), Order::Value), gram.dimension());
    let Some(eigen) = eigen(&DMatrix::from_fn(d, d, |i, j| h.value(i, j))) else {
        return Interval::UNDEFINED;
    };
    let u = eigen.eigenvectors.column(which(&eigen.eigenvalues)).into_owned();
    let h = gram.expansion(At::Space(&points(x)), Order::Value);
    form(|i, j| h.value(i, j), &u) / square(&u)
}
