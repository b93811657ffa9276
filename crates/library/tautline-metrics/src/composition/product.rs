//! The product of two metrics: `diag(H(x), H′(y))` on pairs of points.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::{Bounded, Constants, KnownDistance, LocalError, LocallyBounded, Metric};

/// `diag(H(x), H′(y))` on the pairs `(x, y)` of `R^{D₁} × R^{D₂}`: two systems that move together,
/// each with its own metric.
///
/// A curve is a geodesic if both of its parts are. The product compiles only for `D = D₁ + D₂`:
///
/// ```compile_fail
/// use tautline_metrics::{Metric, composition::Product, gallery::Valleys};
///
/// let product = Product::<_, _, 2, 1>::new(Valleys, Valleys);
/// let h = product.gram(&nalgebra::vector![0.0, 0.0, 0.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Product<A, B, const D1: usize, const D2: usize> {
    first: A,
    second: B,
}

impl<A: Metric<D1>, B: Metric<D2>, const D1: usize, const D2: usize> Product<A, B, D1, D2> {
    /// Returns the product of a metric on `R^{D₁}` and one on `R^{D₂}`.
    #[must_use]
    pub const fn new(first: A, second: B) -> Self {
        Self { first, second }
    }
}

/// Does not compile unless `D = D₁ + D₂`.
fn dimensions_add_up<const D1: usize, const D2: usize, const D: usize>() {
    const { assert!(D1 + D2 == D, "a product of R^D1 and R^D2 is a metric on R^(D1 + D2)") };
}

/// Returns the first `D₁` and the last `D₂` entries of a vector.
fn split<T: nalgebra::Scalar + Copy, const D1: usize, const D2: usize, const D: usize>(
    x: &SVector<T, D>,
) -> (SVector<T, D1>, SVector<T, D2>) {
    dimensions_add_up::<D1, D2, D>();
    (SVector::from_fn(|i, _| x[i]), SVector::from_fn(|i, _| x[D1 + i]))
}

impl<A, B, const D1: usize, const D2: usize, const D: usize> Metric<D> for Product<A, B, D1, D2>
where
    A: Metric<D1>,
    B: Metric<D2>,
{
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let (x, y) = split(x);
        let (first, second) = (self.first.gram(&x), self.second.gram(&y));
        SMatrix::from_fn(|i, j| match (i < D1, j < D1) {
            (true, true) => first[(i, j)],
            (false, false) => second[(i - D1, j - D1)],
            _ => S::zero(),
        })
    }
}

impl<A, B, const D1: usize, const D2: usize, const D: usize> Bounded<D> for Product<A, B, D1, D2>
where
    A: Bounded<D1>,
    B: Bounded<D2>,
{
    /// Returns the smaller `c₁` and the larger of each of the other constants
    /// ([`Constants::beside`]).
    fn constants(&self) -> Constants {
        dimensions_add_up::<D1, D2, D>();
        self.first.constants().beside(self.second.constants())
    }
}

impl<A, B, const D1: usize, const D2: usize, const D: usize> LocallyBounded<D>
    for Product<A, B, D1, D2>
where
    A: LocallyBounded<D1>,
    B: LocallyBounded<D2>,
{
    /// A ball lies in the product of two balls of the same radius.
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        let (x, y) = split(centre);
        let first = self.first.constants_within(&x, radius)?;
        Ok(first.beside(self.second.constants_within(&y, radius)?))
    }
}

impl<A, B, const D1: usize, const D2: usize, const D: usize> KnownDistance<D>
    for Product<A, B, D1, D2>
where
    A: KnownDistance<D1>,
    B: KnownDistance<D2>,
{
    /// Returns `√(d² + d′²)`, or `None` if one of the two is not known.
    ///
    /// The pair of minimal geodesics is minimal, since `∫ √(a² + b²) ≥ √((∫ a)² + (∫ b)²)`, with
    /// equality for constant `a` and `b`.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let ((x, x_second), (y, y_second)) = (split(x), split(y));
        let first = self.first.distance(&x, &y)?;
        Some(first.hypot(self.second.distance(&x_second, &y_second)?))
    }
}
