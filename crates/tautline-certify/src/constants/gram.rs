//! `Gram`: a metric, its Gram matrix and its derivatives over the numbers that bounds are made of.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::formula::is_isotropic;

/// A metric, and what its formula shows at once.
///
/// Behind a pointer, so that a search for a constant is compiled once for each dimension, and not
/// for each metric.
#[derive(Clone, Copy)]
pub(super) struct Gram<'a, const D: usize> {
    formula: &'a dyn Formula<D>,
    /// Whether `H = φ I`.
    pub(super) isotropic: bool,
}

impl<'a, const D: usize> Gram<'a, D> {
    pub(super) fn new(metric: &'a impl Metric<D>) -> Self {
        Self { formula: metric, isotropic: is_isotropic(metric) }
    }

    /// Returns `H(x)`, from the entries on and above the diagonal.
    pub(super) fn at<T: Number<D>>(&self, x: &SVector<T, D>) -> DMatrix<T> {
        let gram = T::of(self.formula).gram(x);
        DMatrix::from_fn(D, D, |i, j| gram[(i.min(j), i.max(j))])
    }

    /// Returns `∂ₖH` for `k = 0, …, D − 1`, from the entries on and above the diagonal.
    pub(super) fn first<T: Number<D>>(&self, x: &SVector<T, D>) -> [SMatrix<T, D, D>; D] {
        let gram = T::of(self.formula).first(x);
        std::array::from_fn(|k| SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].first(k)))
    }

    /// Returns `∂ₖ∂ₗH` at `[k][l]`, from the entries on and above the diagonal.
    pub(super) fn second<T: Number<D>>(&self, x: &SVector<T, D>) -> [[SMatrix<T, D, D>; D]; D] {
        let gram = T::of(self.formula).second(x);
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].second(k.min(l), k.max(l)))
            })
        })
    }

    /// Returns whether the formula is not shown to be defined at `x`.
    pub(super) fn is_undefined(&self, x: &SVector<f64, D>) -> bool {
        self.at(&x.map(Interval::point)).iter().any(|entry| entry.is_undefined())
    }
}

/// A formula for the entries of a matrix over all numbers that bounds are made of.
pub(super) trait Formula<const D: usize>:
    Over<f64, D> + Over<Interval, D> + Over<Jet1<Interval, D>, D> + Sync
{
}

impl<M: Metric<D>, const D: usize> Formula<D> for M {}

/// A formula, with its first and second derivatives, over one type of numbers.
pub(super) trait Over<T, const D: usize> {
    fn gram(&self, x: &SVector<T, D>) -> SMatrix<T, D, D>;
    fn first(&self, x: &SVector<T, D>) -> SMatrix<Jet1<T, D>, D, D>;
    fn second(&self, x: &SVector<T, D>) -> SMatrix<Jet2<T, D>, D, D>;
}

impl<M: Metric<D>, T: Scalar, const D: usize> Over<T, D> for M {
    fn gram(&self, x: &SVector<T, D>) -> SMatrix<T, D, D> {
        Metric::gram(self, x)
    }

    fn first(&self, x: &SVector<T, D>) -> SMatrix<Jet1<T, D>, D, D> {
        Metric::gram(self, &SVector::from(Jet1::variables(&(*x).into())))
    }

    fn second(&self, x: &SVector<T, D>) -> SMatrix<Jet2<T, D>, D, D> {
        Metric::gram(self, &SVector::from(Jet2::variables(&(*x).into())))
    }
}

/// A number that bounds are made of.
pub(super) trait Number<const D: usize>: Scalar {
    fn of(formula: &dyn Formula<D>) -> &dyn Over<Self, D>;
}

impl<const D: usize> Number<D> for f64 {
    fn of(formula: &dyn Formula<D>) -> &dyn Over<Self, D> {
        formula
    }
}

impl<const D: usize> Number<D> for Interval {
    fn of(formula: &dyn Formula<D>) -> &dyn Over<Self, D> {
        formula
    }
}

impl<const D: usize> Number<D> for Jet1<Interval, D> {
    fn of(formula: &dyn Formula<D>) -> &dyn Over<Self, D> {
        formula
    }
}
