//! `AnyMetric`: a metric of which only the dimension is known when a program is compiled.

use std::{any::Any, sync::OnceLock};

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{Jet1, Jet2, MixedJet, Scalar};

use crate::{Formula, batch::CHUNK};

/// A metric behind a pointer: what is done with it is compiled once for each dimension, and not for each
/// metric.
///
/// In `f64` and in [`Jet2`] over it the metric's own formula is evaluated as it is compiled; in all other
/// numbers what was recorded of it, which gives the same bits. Of a formula that cannot be recorded, jets of
/// other kinds over `f64` are the same to rounding, and what else there is, such as an
/// [`Interval`](tautline_scalar::Interval), is undefined: it would be frozen on one branch.
///
/// ```
/// use nalgebra::vector;
/// use tautline_formula::AnyMetric;
/// use tautline_metrics::{Metric, gallery};
///
/// let shear = gallery::Shear::new(0.5, 1.0).expect("a wave number");
/// let metrics = [AnyMetric::new(&shear), AnyMetric::new(&gallery::Valleys)];
/// let x = vector![0.3, -1.2];
/// assert_eq!(metrics[0].gram(&x), shear.gram(&x));
/// ```
pub struct AnyMetric<'m, const D: usize> {
    compiled: &'m dyn Compiled<D>,
    formula: OnceLock<Option<Formula<D>>>,
}

impl<'m, const D: usize> AnyMetric<'m, D> {
    /// Points to a metric.
    #[must_use]
    pub fn new(metric: &'m impl Metric<D>) -> Self {
        Self { compiled: metric, formula: OnceLock::new() }
    }

    /// Returns its formula; `None` if it cannot be recorded.
    #[must_use]
    pub fn formula(&self) -> Option<&Formula<D>> {
        self.formula.get_or_init(|| self.compiled.record()).as_ref()
    }
}

impl<const D: usize> Clone for AnyMetric<'_, D> {
    fn clone(&self) -> Self {
        Self { compiled: self.compiled, formula: self.formula.clone() }
    }
}

impl<const D: usize> std::fmt::Debug for AnyMetric<'_, D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("AnyMetric").field("formula", &self.formula()).finish_non_exhaustive()
    }
}

/// Returns the value of `$over`, if its numbers are those of `$x`: which is decided when it is compiled.
macro_rules! if_same_numbers {
    ($over:expr, $method:ident($x:ident $(, $u:ident)?)) => {
        if let Some(x) = ($x as &dyn Any).downcast_ref() {
            let value = $over.$method(x $(, $u)?);
            if let Some(&value) = (&value as &dyn Any).downcast_ref() {
                return value;
            }
        }
    };
}

impl<const D: usize> Metric<D> for AnyMetric<'_, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        if_same_numbers!(self.compiled.numbers(), gram(x));
        if_same_numbers!(self.compiled.jets(), gram(x));
        match self.formula() {
            Some(formula) => Metric::gram(formula, x),
            None => self.expanded(x),
        }
    }

    fn norm_squared<S: Scalar>(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S {
        if_same_numbers!(self.compiled.numbers(), norm_squared(x, u));
        if_same_numbers!(self.compiled.jets(), norm_squared(x, u));
        Metric::norm_squared(&ByGram(self), x, u)
    }

    fn momentum<S: Scalar>(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> SVector<S, D> {
        if_same_numbers!(self.compiled.numbers(), momentum(x, u));
        if_same_numbers!(self.compiled.jets(), momentum(x, u));
        Metric::momentum(&ByGram(self), x, u)
    }
}

impl<const D: usize> AnyMetric<'_, D> {
    /// `H` in jets of another kind, of which three factors that are 0 at `x` have the product 0: to the
    /// second order it is all of `H`.
    fn expanded<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let places: Option<Vec<f64>> = x.iter().map(value::<S, D>).collect();
        let Some(places) = places else { return SMatrix::from_element(S::constant(f64::NAN)) };
        let place = SVector::<f64, D>::from_iterator(places);
        let jets = self.compiled.jets().gram(&SVector::from(Jet2::variables(&place.into())));
        let step = |k: usize| x[k] - place[k];
        jets.map(|jet| {
            (0..D).fold(S::constant(jet.value()), |sum, k| {
                let turned = (0..D).fold(S::constant(jet.first(k)), |sum, l| {
                    sum + step(l) * (0.5 * jet.second(k.min(l), k.max(l)))
                });
                sum + step(k) * turned
            })
        })
    }
}

/// The number that a jet over `f64` is at its place; `None` for other numbers.
fn value<S: Scalar, const D: usize>(x: &S) -> Option<f64> {
    let x: &dyn Any = x;
    let first = || Some(x.downcast_ref::<Jet1<f64, D>>()?.value());
    let along = || Some(x.downcast_ref::<Jet1<f64, 1>>()?.value());
    let twice_along = || Some(x.downcast_ref::<Jet2<f64, 1>>()?.value());
    let chunk = || Some(x.downcast_ref::<Jet1<f64, CHUNK>>()?.value());
    let mixed = || Some(x.downcast_ref::<MixedJet<f64, CHUNK>>()?.value());
    first().or_else(along).or_else(twice_along).or_else(chunk).or_else(mixed)
}

/// What follows from the Gram matrix alone.
struct ByGram<'a, 'm, const D: usize>(&'a AnyMetric<'m, D>);

impl<const D: usize> Metric<D> for ByGram<'_, '_, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        Metric::gram(self.0, x)
    }
}

/// A formula as it is compiled, in `f64` and in jets over it.
trait Compiled<const D: usize>: Sync {
    fn numbers(&self) -> &dyn Forms<f64, D>;
    fn jets(&self) -> &dyn Forms<Jet2<f64, D>, D>;
    fn record(&self) -> Option<Formula<D>>;
}

impl<M: Metric<D>, const D: usize> Compiled<D> for M {
    fn numbers(&self) -> &dyn Forms<f64, D> {
        self
    }

    fn jets(&self) -> &dyn Forms<Jet2<f64, D>, D> {
        self
    }

    fn record(&self) -> Option<Formula<D>> {
        Formula::record(self).ok()
    }
}

/// A metric in one type of numbers.
trait Forms<S, const D: usize> {
    fn gram(&self, x: &SVector<S, D>) -> SMatrix<S, D, D>;
    fn norm_squared(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S;
    fn momentum(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> SVector<S, D>;
}

impl<M: Metric<D>, S: Scalar, const D: usize> Forms<S, D> for M {
    fn gram(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        Metric::gram(self, x)
    }

    fn norm_squared(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S {
        Metric::norm_squared(self, x, u)
    }

    fn momentum(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> SVector<S, D> {
        Metric::momentum(self, x, u)
    }
}
