//! `AnyMetric`: a metric behind a pointer, of which only the dimension is known at compile time.

use std::{
    any::{Any, TypeId},
    sync::OnceLock,
};

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{Jet1, Jet2, Scalar};

use crate::{
    Formula, RecordError,
    batch::CHUNKED,
    recording::{self, Symbol},
};

/// A metric behind a pointer. Code that takes it is compiled once for each dimension, not for each
/// metric.
///
/// In `f64` it calls the metric's own `H`. In fewer than 24 dimensions it does so as well in
/// [`Jet1`] and [`Jet2`] over `f64`, with all coordinates as variables. In all other number types
/// it evaluates the recorded formula, which gives the same bits.
///
/// If the formula cannot be recorded, jets over `f64` along a line still work in fewer than 24
/// dimensions. They are computed from an expansion to second order, up to rounding. In any other
/// number type, such as an [`Interval`](tautline_scalar::Interval), `H` is NaN, since intervals
/// would follow only one branch.
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
    formula: OnceLock<Result<Formula<D>, RecordError>>,
}

impl<'m, const D: usize> AnyMetric<'m, D> {
    /// Returns a pointer to a metric.
    #[must_use]
    pub fn new(metric: &'m impl Metric<D>) -> Self {
        Self { compiled: metric, formula: OnceLock::new() }
    }

    /// Returns the metric's formula, which is recorded on first use.
    ///
    /// # Errors
    ///
    /// The errors of [`Formula::record`].
    pub fn formula(&self) -> Result<&Formula<D>, RecordError> {
        self.formula.get_or_init(|| self.compiled.record()).as_ref().map_err(|&error| error)
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

impl<const D: usize> Metric<D> for AnyMetric<'_, D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        // The compiler decides these comparisons of types.
        if TypeId::of::<S>() == TypeId::of::<f64>()
            && let Some(h) = gram(self.compiled.numbers(), x)
        {
            return h;
        }
        if TypeId::of::<S>() == TypeId::of::<Jet1<f64, D>>()
            && let Some(h) = self.compiled.first_jets().and_then(|jets| gram(jets, x))
        {
            return h;
        }
        if TypeId::of::<S>() == TypeId::of::<Jet2<f64, D>>()
            && let Some(h) = self.compiled.second_jets().and_then(|jets| gram(jets, x))
        {
            return h;
        }
        match self.formula() {
            Ok(formula) => Metric::gram(formula, x),
            Err(error) => self.expanded(x, error),
        }
    }
}

// This is a separate function, because in an unoptimised build a caller that needs only numbers
// would otherwise reserve stack for the matrix of jets.
#[inline]
fn gram<T: Scalar, S: Scalar, const D: usize>(
    metric: &dyn Gram<T, D>,
    x: &SVector<S, D>,
) -> Option<SMatrix<S, D, D>> {
    same(&metric.gram(same(x)?)).copied()
}

/// Returns the value if `T` is `S`.
#[inline]
fn same<T: Any, S: Any>(value: &T) -> Option<&S> {
    (value as &dyn Any).downcast_ref()
}

impl<const D: usize> AnyMetric<'_, D> {
    /// Returns `H` in another kind of jet, computed from its second-order Taylor expansion.
    fn expanded<S: Scalar>(&self, x: &SVector<S, D>, error: RecordError) -> SMatrix<S, D, D> {
        let jets = |place: &SVector<f64, D>| {
            let jets = self.compiled.second_jets()?;
            Some(jets.gram(&SVector::from(Jet2::variables(&(*place).into()))))
        };
        expanded(x, error, jets, |jets, (i, j), directions| {
            let jet = &jets[(i, j)];
            match *directions {
                [] => jet.value(),
                [k] => jet.first(k),
                [k, l, ..] => jet.second(k.min(l), k.max(l)),
            }
        })
    }
}

/// Returns `H` in jets over `f64`, computed from its second-order Taylor expansion at their values.
/// This is exact for jets of order at most two, in which a product of three increments vanishes. In
/// other number types `H` is NaN, and a recording fails with `error`.
///
/// `expand` expands `H` at a point. `derivative` reads an entry from the expansion, differentiated in
/// none, one or two directions.
pub(crate) fn expanded<S: Scalar, T, const D: usize>(
    x: &SVector<S, D>,
    error: RecordError,
    expand: impl FnOnce(&SVector<f64, D>) -> Option<T>,
    derivative: impl Fn(&T, (usize, usize), &[usize]) -> f64,
) -> SMatrix<S, D, D> {
    let places: Option<Vec<f64>> = x.iter().map(value::<S, D>).collect();
    if places.is_none() && (x as &dyn Any).is::<SVector<Symbol, D>>() {
        recording::fail(error);
    }
    let place = places.map(SVector::<f64, D>::from_iterator);
    let Some((place, expansion)) = place.and_then(|place| Some((place, expand(&place)?))) else {
        return SMatrix::from_element(S::constant(f64::NAN));
    };
    let step = |k: usize| x[k] - place[k];
    SMatrix::from_fn(|i, j| {
        let of = |directions: &[usize]| derivative(&expansion, (i, j), directions);
        (0..D).fold(S::constant(of(&[])), |sum, k| {
            let turned =
                (0..D).fold(S::constant(of(&[k])), |sum, l| sum + step(l) * (0.5 * of(&[k, l])));
            sum + step(k) * turned
        })
    })
}

/// Returns an `f64` or the value of a jet over it, and `None` for other numbers.
pub(crate) fn value<S: Scalar, const D: usize>(x: &S) -> Option<f64> {
    let x: &dyn Any = x;
    let number = || x.downcast_ref::<f64>().copied();
    let first = || Some(x.downcast_ref::<Jet1<f64, D>>()?.value());
    let second = || Some(x.downcast_ref::<Jet2<f64, D>>()?.value());
    let along = || Some(x.downcast_ref::<Jet1<f64, 1>>()?.value());
    let twice_along = || Some(x.downcast_ref::<Jet2<f64, 1>>()?.value());
    number().or_else(first).or_else(second).or_else(along).or_else(twice_along)
}

/// A compiled metric, in `f64` and in jets over it.
trait Compiled<const D: usize>: Sync {
    fn numbers(&self) -> &dyn Gram<f64, D>;
    fn first_jets(&self) -> Option<&dyn Gram<Jet1<f64, D>, D>>;
    fn second_jets(&self) -> Option<&dyn Gram<Jet2<f64, D>, D>>;
    fn record(&self) -> Result<Formula<D>, RecordError>;
}

impl<M: Metric<D>, const D: usize> Compiled<D> for M {
    fn numbers(&self) -> &dyn Gram<f64, D> {
        self
    }

    fn first_jets(&self) -> Option<&dyn Gram<Jet1<f64, D>, D>> {
        // The condition is a constant: larger matrices of jets would overflow the stack, and are
        // not compiled; nor are those of recorded steps, which give the same bits.
        if const { D < CHUNKED && !M::IS_RECORDED } { Some(self) } else { None }
    }

    fn second_jets(&self) -> Option<&dyn Gram<Jet2<f64, D>, D>> {
        if const { D < CHUNKED && !M::IS_RECORDED } { Some(self) } else { None }
    }

    fn record(&self) -> Result<Formula<D>, RecordError> {
        Formula::record(self)
    }
}

/// A metric in one number type.
trait Gram<S, const D: usize> {
    fn gram(&self, x: &SVector<S, D>) -> SMatrix<S, D, D>;
}

impl<M: Metric<D>, S: Scalar, const D: usize> Gram<S, D> for M {
    fn gram(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        Metric::gram(self, x)
    }
}
