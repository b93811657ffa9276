//! `AnyMetric`: a metric of which only the dimension is known when a program is compiled.

use std::{any::Any, sync::OnceLock};

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{Jet1, Jet2, MixedJet, Scalar};

use crate::{Formula, batch::CHUNK};

/// A metric behind a pointer: what is done with it is compiled once for each dimension, and not for each
/// metric.
///
/// In `f64` and in jets over it the metric's own formula is evaluated as it is compiled; in all other numbers
/// what was recorded of it, which gives the same bits. A formula that cannot be recorded is not a number
/// there.
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

/// Asks in the type of numbers that `S` is, or else the formula.
macro_rules! ask {
    ($self:ident.$method:ident($x:ident $(, $u:ident)?), else $missing:expr) => {{
        let compiled = $self.compiled;
        ask!(compiled.numbers().$method($x $(, $u)?));
        ask!(compiled.jets().$method($x $(, $u)?));
        ask!(compiled.second_jets().$method($x $(, $u)?));
        ask!(compiled.jets_along().$method($x $(, $u)?));
        ask!(compiled.second_jets_along().$method($x $(, $u)?));
        ask!(compiled.chunks().$method($x $(, $u)?));
        ask!(compiled.mixed_chunks().$method($x $(, $u)?));
        match $self.formula() {
            Some(formula) => Metric::$method(formula, $x $(, $u)?),
            None => $missing,
        }
    }};
    ($compiled:ident.$numbers:ident().$method:ident($x:ident $(, $u:ident)?)) => {
        // Decided when it is compiled: of the types of two numbers, nothing is left to be looked at.
        if let Some(x) = ($x as &dyn Any).downcast_ref() {
            let value = $compiled.$numbers().$method(x $(, $u)?);
            if let Some(&value) = (&value as &dyn Any).downcast_ref() {
                return value;
            }
        }
    };
}

impl<const D: usize> Metric<D> for AnyMetric<'_, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        ask!(self.gram(x), else SMatrix::from_element(S::constant(f64::NAN)))
    }

    fn norm_squared<S: Scalar>(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S {
        ask!(self.norm_squared(x, u), else S::constant(f64::NAN))
    }

    fn momentum<S: Scalar>(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> SVector<S, D> {
        ask!(self.momentum(x, u), else SVector::from_element(S::constant(f64::NAN)))
    }
}

/// A formula as it is compiled, in the numbers that a search asks for thousands of times.
trait Compiled<const D: usize>: Sync {
    fn numbers(&self) -> &dyn Over<f64, D>;
    fn jets(&self) -> &dyn Over<Jet1<f64, D>, D>;
    fn second_jets(&self) -> &dyn Over<Jet2<f64, D>, D>;
    fn jets_along(&self) -> &dyn Over<Jet1<f64, 1>, D>;
    fn second_jets_along(&self) -> &dyn Over<Jet2<f64, 1>, D>;
    fn chunks(&self) -> &dyn Over<Jet1<f64, CHUNK>, D>;
    fn mixed_chunks(&self) -> &dyn Over<MixedJet<f64, CHUNK>, D>;
    fn record(&self) -> Option<Formula<D>>;
}

impl<M: Metric<D>, const D: usize> Compiled<D> for M {
    fn numbers(&self) -> &dyn Over<f64, D> {
        self
    }

    fn jets(&self) -> &dyn Over<Jet1<f64, D>, D> {
        self
    }

    fn second_jets(&self) -> &dyn Over<Jet2<f64, D>, D> {
        self
    }

    fn jets_along(&self) -> &dyn Over<Jet1<f64, 1>, D> {
        self
    }

    fn second_jets_along(&self) -> &dyn Over<Jet2<f64, 1>, D> {
        self
    }

    fn chunks(&self) -> &dyn Over<Jet1<f64, CHUNK>, D> {
        self
    }

    fn mixed_chunks(&self) -> &dyn Over<MixedJet<f64, CHUNK>, D> {
        self
    }

    fn record(&self) -> Option<Formula<D>> {
        Formula::record(self).ok()
    }
}

/// A metric in one type of numbers.
trait Over<S, const D: usize> {
    fn gram(&self, x: &SVector<S, D>) -> SMatrix<S, D, D>;
    fn norm_squared(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> S;
    fn momentum(&self, x: &SVector<S, D>, u: &SVector<f64, D>) -> SVector<S, D>;
}

impl<M: Metric<D>, S: Scalar, const D: usize> Over<S, D> for M {
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
