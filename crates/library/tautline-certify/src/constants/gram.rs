//! `Gram`: a metric with the derivatives of its Gram matrix, in any number type.

use tautline_formula::Formula;
use tautline_scalar::{ANY, Interval};

use super::{
    expansion::Expansion,
    lifted::{self, Variable},
    rows::Order,
};
use crate::{
    formula::{Lift, is_isotropic},
    patch::Point,
};

/// A metric, together with what its formula shows.
#[derive(Clone, Copy)]
pub(super) struct Gram<'a> {
    formula: &'a Formula<ANY>,
    /// Whether the formula shows that `H = φ I`.
    pub(super) isotropic: bool,
    /// The lifted formula, if the search is in its variables.
    lift: Option<&'a Lift>,
}

/// A place at which a metric is evaluated.
#[derive(Clone, Copy)]
pub(super) enum At<'p, T> {
    /// A point of space, in `ℓ`.
    Space(&'p [T]),
    /// Values of the coordinates of the search, in a chart.
    Search(&'p [T], usize),
}

impl<'p> From<&'p Point> for At<'p, f64> {
    fn from(point: &'p Point) -> Self {
        At::Search(&point.at, point.chart)
    }
}

impl<'a> Gram<'a> {
    pub(super) fn new(formula: &'a Formula<ANY>, lift: Option<&'a Lift>) -> Self {
        Self { formula, isotropic: is_isotropic(formula), lift }
    }

    /// Returns the dimension of space.
    pub(super) fn dimension(&self) -> usize {
        self.formula.dimension()
    }

    /// Returns points of space with about these coordinates of the search, in `ℓ`; in a search
    /// without a lift, the point itself.
    pub(super) fn in_space(&self, point: &Point) -> Vec<Vec<f64>> {
        match self.lift {
            Some(lift) => lift.in_space(point),
            None => vec![point.at.clone()],
        }
    }

    /// Returns `H` with its derivatives in the coordinates of space, up to this order.
    pub(super) fn expansion<T: Variable>(&self, at: At<'_, T>, order: Order) -> Expansion<T> {
        match (at, self.lift) {
            (At::Search(at, chart), Some(lift)) => lifted::expansion(lift, at, chart, order),
            (At::Space(x) | At::Search(x, _), _) => Expansion::of(self.formula, x, order),
        }
    }

    /// Returns whether the formula, evaluated in intervals, may be undefined at a point of space.
    pub(super) fn is_undefined(&self, x: &[f64]) -> bool {
        let at = points(x);
        let gram = self.expansion(At::Space(&at), Order::Value);
        gram.numbers().iter().any(|entry| entry.is_undefined())
    }
}

/// Returns a point, in intervals.
pub(super) fn points(x: &[f64]) -> Vec<Interval> {
    x.iter().map(|&x| Interval::point(x)).collect()
}
