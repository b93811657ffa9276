//! `Gram`: a metric with the derivatives of its Gram matrix, in any number type.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_formula::{AnyMetric, Formula};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::formula::is_isotropic;

/// A metric, together with what its formula shows.
#[derive(Clone, Copy)]
pub(super) struct Gram<'a, const D: usize> {
    metric: &'a AnyMetric<'a, D>,
    /// Whether the formula shows that `H = φ I`.
    pub(super) isotropic: bool,
}

impl<'a, const D: usize> Gram<'a, D> {
    pub(super) fn new(metric: &'a AnyMetric<'a, D>, formula: &Formula<D>) -> Self {
        Self { metric, isotropic: is_isotropic(formula) }
    }

    /// Returns `H(x)`, from the entries on and above the diagonal.
    pub(super) fn at<T: Scalar>(&self, x: &SVector<T, D>) -> DMatrix<T> {
        let gram = self.metric.gram(x);
        DMatrix::from_fn(D, D, |i, j| gram[(i.min(j), i.max(j))])
    }

    /// Returns `∂ₖH` for `k = 0, …, D − 1`, from the entries on and above the diagonal.
    pub(super) fn first<T: Scalar>(&self, x: &SVector<T, D>) -> [SMatrix<T, D, D>; D] {
        let gram = self.metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
        std::array::from_fn(|k| SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].first(k)))
    }

    /// Returns `∂ₖ∂ₗH` at `[k][l]`, from the entries on and above the diagonal.
    pub(super) fn second<T: Scalar>(&self, x: &SVector<T, D>) -> [[SMatrix<T, D, D>; D]; D] {
        let gram = self.metric.gram(&SVector::from(Jet2::variables(&(*x).into())));
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].second(k.min(l), k.max(l)))
            })
        })
    }

    /// Returns whether the formula, evaluated in intervals, may be undefined at `x`.
    pub(super) fn is_undefined(&self, x: &SVector<f64, D>) -> bool {
        self.at(&x.map(Interval::point)).iter().any(|entry| entry.is_undefined())
    }
}
