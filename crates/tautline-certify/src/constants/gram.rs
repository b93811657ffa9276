//! `Gram`: a metric with the derivatives of its Gram matrix, in any number type.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_formula::{AnyMetric, Formula};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2};

use super::lifted::{self, Expansion, Variable};
use crate::{
    formula::{Lift, is_isotropic},
    patch::Point,
};

/// A metric, together with what its formula shows.
#[derive(Clone, Copy)]
pub(super) struct Gram<'a, const D: usize> {
    metric: &'a AnyMetric<'a, D>,
    /// Whether the formula shows that `H = φ I`.
    pub(super) isotropic: bool,
    /// The lifted formula, if the search is in its variables.
    lift: Option<&'a Lift<D>>,
}

/// A place at which a metric is evaluated.
#[derive(Clone, Copy)]
pub(super) enum At<'p, T, const D: usize> {
    /// A point of space, in `ℓ`.
    Space(&'p SVector<T, D>),
    /// Values of the coordinates of the search, in a chart.
    Search(&'p [T], usize),
}

impl<'p, const D: usize> From<&'p Point> for At<'p, f64, D> {
    fn from(point: &'p Point) -> Self {
        At::Search(&point.at, point.chart)
    }
}

impl<'a, const D: usize> Gram<'a, D> {
    pub(super) fn new(
        metric: &'a AnyMetric<'a, D>,
        formula: &Formula<D>,
        lift: Option<&'a Lift<D>>,
    ) -> Self {
        Self { metric, isotropic: is_isotropic(formula), lift }
    }

    /// Returns points of space with about these coordinates of the search, in `ℓ`; in a search
    /// without a lift, the point itself.
    pub(super) fn in_space(&self, point: &Point) -> Vec<SVector<f64, D>> {
        match self.lift {
            Some(lift) => lift.in_space(point),
            None => vec![SVector::from_column_slice(&point.at)],
        }
    }

    fn expansion<T: Variable, J: Expansion<T, D>>(
        &self,
        at: At<'_, T, D>,
        variables: impl Fn(&[T; D]) -> [J; D],
    ) -> SMatrix<J, D, D> {
        let x = match (at, self.lift) {
            (At::Space(x), _) => *x,
            (At::Search(at, _), None) => SVector::from_column_slice(at),
            (At::Search(at, chart), Some(lift)) => return lifted::gram(lift, at, chart),
        };
        self.metric.gram(&SVector::from(variables(&x.into())))
    }

    /// Returns `H(x)`, from the entries on and above the diagonal.
    pub(super) fn at<T: Variable>(&self, at: At<'_, T, D>) -> DMatrix<T> {
        let gram = self.expansion(at, |x| *x);
        DMatrix::from_fn(D, D, |i, j| gram[(i.min(j), i.max(j))])
    }

    /// Returns `∂ₖH` for `k = 0, …, D − 1`, from the entries on and above the diagonal.
    pub(super) fn first<T: Variable>(&self, at: At<'_, T, D>) -> [SMatrix<T, D, D>; D] {
        let gram = self.expansion(at, Jet1::variables);
        std::array::from_fn(|k| SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].first(k)))
    }

    /// Returns `∂ₖ∂ₗH` at `[k][l]`, from the entries on and above the diagonal.
    pub(super) fn second<T: Variable>(&self, at: At<'_, T, D>) -> [[SMatrix<T, D, D>; D]; D] {
        let gram = self.expansion(at, Jet2::variables);
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))].second(k.min(l), k.max(l)))
            })
        })
    }

    /// Returns whether the formula, evaluated in intervals, may be undefined at a point of space.
    pub(super) fn is_undefined(&self, x: &SVector<f64, D>) -> bool {
        self.at(At::Space(&x.map(Interval::point))).iter().any(|entry| entry.is_undefined())
    }
}
