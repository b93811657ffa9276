//! `BlackBox`: a metric that is known by its values only.

mod batches;
mod differences;

use std::{any::Any, fmt::Debug, sync::Arc};

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Scalar};

use crate::{
    RecordError,
    any_metric::{expanded, value},
};

pub use batches::BlackBoxBatches;

/// The values of a metric on `R^D` at `m` points at once, from a program that is no formula, such as a
/// neural network.
///
/// The points are given one after the other, as `m D` numbers. A caller that cannot compute a value
/// returns NaN for it.
pub trait Values: Send + Sync {
    /// Returns `H`, as `m D²` numbers: the entry `(i, j)` at point `p` is number `(p D + i) D + j`.
    fn gram(&self, x: &[f64]) -> Vec<f64>;

    /// Returns the derivatives `∂ₖHᵢⱼ`, as `m D³` numbers with `k` last, or `None` if they are to be
    /// computed from differences of `H`.
    fn first(&self, _x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Returns the derivatives `∂ₖ∂ₗHᵢⱼ`, as `m D⁴` numbers with `k` and `l` last, or `None` if they are
    /// to be computed from differences.
    fn second(&self, _x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Returns whether [`first_along`](Values::first_along) has an answer. The other derivatives are then not
    /// asked for: a point has `D²` numbers, not `D⁴`, so that the dimension has no limit.
    fn is_along(&self) -> bool {
        false
    }

    /// Returns the derivatives `∂ₖ(H v)ᵢ` along a vector `v` for each point, as `m D²` numbers with `k`
    /// last.
    fn first_along(&self, _x: &[f64], _v: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Returns the derivatives `∂ₖ∂ₗ(vᵀHv)`, as `m D²` numbers, or `None` if they are to be computed from
    /// differences of those of [`first_along`](Values::first_along).
    fn second_along(&self, _x: &[f64], _v: &[f64]) -> Option<Vec<f64>> {
        None
    }
}

/// A metric that is known by its values only. It can be solved, evaluated and compared; what needs a
/// formula, such as a certificate, is refused with [`RecordError::BlackBox`].
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`].
///
/// ```
/// use std::sync::Arc;
/// use nalgebra::vector;
/// use tautline_formula::{BlackBox, Values};
/// use tautline_metrics::Metric;
///
/// struct Valleys;
/// impl Values for Valleys {
///     fn gram(&self, x: &[f64]) -> Vec<f64> {
///         let at = |x: &[f64]| (2.0 - x[0].cos()).powi(2);
///         x.chunks(2).flat_map(|x| [at(x), 0.0, 0.0, at(x)]).collect()
///     }
/// }
/// let metric = BlackBox::<2>::new(Arc::new(Valleys), BlackBox::<2>::STEP).expect("a step");
/// assert_eq!(metric.gram(&vector![0.0, 5.0])[(1, 1)], 1.0);
/// ```
#[derive(Clone)]
pub struct BlackBox<const D: usize> {
    dimension: usize,
    values: Arc<dyn Values>,
    step: f64,
}

impl<const D: usize> BlackBox<D> {
    /// The default step of differences: a thousandth of a unit of the coordinates.
    pub const STEP: f64 = 1e-3;

    /// The largest dimension, unless derivatives are given [along a vector](Values::is_along). A point has `D⁴` second derivatives, and differences take twice as many
    /// values: 25 MB for each of at least eight points.
    pub const LARGEST_DIMENSION: usize = 32;

    /// Makes the metric. Derivatives that are not given are computed from differences of values at
    /// points whose coordinates differ by `step`, in `ℓ`.
    ///
    /// The first derivatives have an error of about `h⁴ |∂⁵H| / 30 + 2 ε |H| / h + ε |x| |∂H| / h` for
    /// a step of `h`. A thousandth of the length over which `H` changes is a good step: the first two
    /// terms are then about `10⁻¹²` of the derivative. The last one comes from coordinates that are
    /// rounded when they are moved, and is as small where they are not large, compared with that length.
    /// The second derivatives, which only steer the search, are known to `10⁻⁸`.
    ///
    /// Returns `None` if the step is not positive and finite, or if the dimension is 0 or more than
    /// [`LARGEST_DIMENSION`](BlackBox::LARGEST_DIMENSION) without derivatives along a vector.
    #[must_use]
    pub fn new(values: Arc<dyn Values>, step: f64) -> Option<Self> {
        Self::checked(D, values, step)
    }

    fn checked(dimension: usize, values: Arc<dyn Values>, step: f64) -> Option<Self> {
        let is_small = values.is_along() || dimension <= Self::LARGEST_DIMENSION;
        (dimension > 0 && is_small && step > 0.0 && step.is_finite()).then_some(Self {
            dimension,
            values,
            step,
        })
    }

    /// Returns the dimension of the space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the same metric as one whose dimension is a value.
    #[must_use]
    pub fn into_any(self) -> BlackBox<ANY> {
        let Self { dimension, values, step } = self;
        BlackBox { dimension, values, step }
    }

    /// Returns `H(x)`, as `D²` numbers row by row.
    #[must_use]
    pub fn gram_at(&self, x: &[f64]) -> Vec<f64> {
        self.values.gram(x)
    }
}

impl BlackBox<ANY> {
    /// Makes the metric on `R^dimension` like [`new`](BlackBox::new).
    #[must_use]
    pub fn new_in(dimension: usize, values: Arc<dyn Values>, step: f64) -> Option<Self> {
        Self::checked(dimension, values, step)
    }
}

impl<const D: usize> Debug for BlackBox<D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BlackBox").field("step", &self.step).finish_non_exhaustive()
    }
}

impl<const D: usize> Metric<D> for BlackBox<D> {
    /// Returns `H` in `f64` and in jets over it. In other number types it is NaN.
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        if (x as &dyn Any).is::<SVector<f64, D>>() {
            let place: Vec<f64> = x.iter().filter_map(value::<S, D>).collect();
            let h = self.values.gram(&place);
            return SMatrix::from_fn(|i, j| S::constant(h[i * D + j]));
        }
        let expand = |place: &SVector<f64, D>| Some(self.derivatives(place.as_slice(), 2));
        expanded(x, RecordError::BlackBox, expand, |at, (i, j), directions| {
            let entry = i * D + j;
            match *directions {
                [] => at.gram[entry],
                [k] => at.first[entry * D + k],
                [k, l, ..] => at.second[(entry * D + k) * D + l],
            }
        })
    }
}
