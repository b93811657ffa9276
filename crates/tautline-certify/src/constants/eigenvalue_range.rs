//! `c₁` and `c₂`: the least and the greatest eigenvalue of `H`.

use nalgebra::{DMatrix, DVector, SVector};
use tautline_scalar::{Interval, Scalar};

use super::{
    eigenvalue_bound::eigen,
    gram::Gram,
    spectral::{Spectral, form, square},
};

/// `−λ` for the least eigenvalue `λ` of `H(x)`: at most `−c₁`.
pub(super) struct Least<'a, const D: usize>(pub(super) Gram<'a, D>);

/// The greatest eigenvalue of `H(x)`: at most `c₂`.
pub(super) struct Greatest<'a, const D: usize>(pub(super) Gram<'a, D>);

impl<const D: usize> Spectral<D> for Least<'_, D> {
    type Choice = ();

    fn gram(&self) -> Gram<'_, D> {
        self.0
    }

    fn choice(&self, _: &SVector<f64, D>) {}

    fn matrices<T: Scalar>(&self, x: &SVector<T, D>, _: &()) -> Vec<DMatrix<T>> {
        vec![block(self.0, x).map(|entry| -entry)]
    }

    fn wanted(&self, x: &SVector<f64, D>) -> f64 {
        eigen(&block(self.0, x)).map_or(f64::NAN, |eigen| -eigen.eigenvalues.min())
    }

    /// Returns an upper bound of `λ`.
    fn witness(&self, x: &SVector<f64, D>) -> f64 {
        quotient(self.0, x, |eigenvalues| eigenvalues.imin()).hi()
    }

    /// A least eigenvalue that is certainly not positive.
    fn is_refuted(&self, x: &SVector<f64, D>, value: f64) -> bool {
        (value >= 0.0 && self.witness(x) <= 0.0) || (value.is_nan() && self.0.is_undefined(x))
    }
}

impl<const D: usize> Spectral<D> for Greatest<'_, D> {
    type Choice = ();

    fn gram(&self) -> Gram<'_, D> {
        self.0
    }

    fn choice(&self, _: &SVector<f64, D>) {}

    fn matrices<T: Scalar>(&self, x: &SVector<T, D>, _: &()) -> Vec<DMatrix<T>> {
        vec![block(self.0, x)]
    }

    fn wanted(&self, x: &SVector<f64, D>) -> f64 {
        eigen(&block(self.0, x)).map_or(f64::NAN, |eigen| eigen.eigenvalues.max())
    }

    fn witness(&self, x: &SVector<f64, D>) -> f64 {
        quotient(self.0, x, |eigenvalues| eigenvalues.imax()).lo()
    }
}

/// `H(x)`, or `φ(x)` if that is all.
fn block<T: Scalar, const D: usize>(gram: Gram<'_, D>, x: &SVector<T, D>) -> DMatrix<T> {
    let h = gram.at(x);
    if gram.isotropic { h.view((0, 0), (1, 1)).into_owned() } else { h }
}

/// Rayleigh's quotient `uᵀHu / uᵀu`, enclosed, for an eigenvector `u` up to rounding: between the
/// least and the greatest eigenvalue, whatever `u` is.
fn quotient<const D: usize>(
    gram: Gram<'_, D>,
    x: &SVector<f64, D>,
    which: impl Fn(&DVector<f64>) -> usize,
) -> Interval {
    let Some(eigen) = eigen(&gram.at(x)) else { return Interval::UNDEFINED };
    let vector = eigen.eigenvectors.column(which(&eigen.eigenvalues));
    let u = SVector::<f64, D>::from_fn(|i, _| vector[i]);
    let h = gram.at(&x.map(Interval::point));
    form(|i, j| h[(i, j)], &u) / square(&u)
}
