//! `Gram`: a metric, its Gram matrix and its derivatives over any number type.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::formula::is_isotropic;

/// A metric, and what its formula shows at once.
#[derive(Debug)]
pub(super) struct Gram<'a, M> {
    metric: &'a M,
    /// Whether `H = φ I`.
    pub(super) isotropic: bool,
}

impl<M> Clone for Gram<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Gram<'_, M> {}

impl<'a, M> Gram<'a, M> {
    pub(super) fn new<const D: usize>(metric: &'a M) -> Self
    where
        M: Metric<D>,
    {
        Self { metric, isotropic: is_isotropic(metric) }
    }

    /// Returns `H(x)`, from the entries on and above the diagonal.
    pub(super) fn at<T: Scalar, const D: usize>(&self, x: &SVector<T, D>) -> DMatrix<T>
    where
        M: Metric<D>,
    {
        let gram = self.metric.gram(x);
        DMatrix::from_fn(D, D, |i, j| gram[(i.min(j), i.max(j))])
    }

    /// Returns `∂ₖH` for `k = 0, …, D − 1`, from the entries on and above the diagonal.
    pub(super) fn first<T: Scalar, const D: usize>(
        &self,
        x: &SVector<T, D>,
    ) -> [SMatrix<T, D, D>; D]
    where
        M: Metric<D>,
    {
        let x = Jet1::variables(&std::array::from_fn(|i| x[i]));
        let gram = self.metric.gram(&SVector::from(x));
        std::array::from_fn(|k| SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].first(k)))
    }

    /// Returns `∂ₖ∂ₗH` at `[k][l]`, from the entries on and above the diagonal.
    pub(super) fn second<T: Scalar, const D: usize>(
        &self,
        x: &SVector<T, D>,
    ) -> [[SMatrix<T, D, D>; D]; D]
    where
        M: Metric<D>,
    {
        let x = Jet2::variables(&std::array::from_fn(|i| x[i]));
        let gram = self.metric.gram(&SVector::from(x));
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].second(k.min(l), k.max(l)))
            })
        })
    }

    /// Returns whether the formula is not shown to be defined at `x`.
    pub(super) fn is_undefined<const D: usize>(&self, x: &SVector<f64, D>) -> bool
    where
        M: Metric<D>,
    {
        self.at(&x.map(Interval::point)).iter().any(|entry| entry.is_undefined())
    }
}
