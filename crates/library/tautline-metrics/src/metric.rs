//! `Metric`: a Riemannian metric on `R^D`, and traits for what else may be known about it.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Scalar;

use crate::Constants;

/// A Riemannian metric on `R^D`, given by the formula of its Gram matrix.
///
/// # Laws
///
/// `H(x)` is symmetric and positive definite at every `x` where the metric is defined, and not
/// finite (NaN or infinite) at every other `x`. It is twice continuously differentiable. `gram` is
/// a pure function of `x`, does not panic on finite input, and may be called by several threads at
/// once.
pub trait Metric<const D: usize>: Sync {
    /// Returns the Gram matrix `H(x)`, in `m²/ℓ²`, of size `D × D`.
    ///
    /// The formula is generic in the number type. Literals are `f64` and may be on either side of
    /// an operator; functions are the methods of [`Scalar`]. Write an entry that does not depend on
    /// `x` as `S::constant(2.0)`, `S::zero()` or `S::one()`.
    ///
    /// ```
    /// use nalgebra::{SMatrix, SVector, matrix, vector};
    /// use tautline_metrics::{Metric, Scalar, check_gram};
    ///
    /// struct Sheet {
    ///     height: f64,
    /// }
    ///
    /// impl Metric<2> for Sheet {
    ///     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
    ///         let wave = 2.0 - self.height * x[0].cos();
    ///         let well = 1.0 + 3.0 / (1.0 + x[1].sqr());
    ///         matrix![wave.sqr(), 0.5 * x[0].sin();
    ///                 0.5 * x[0].sin(), well + S::constant(0.25)]
    ///     }
    /// }
    /// assert!(check_gram(&Sheet { height: 0.9 }, &vector![0.3, 1.0]).is_ok());
    /// ```
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D>;

    /// Whether `gram` evaluates recorded steps one by one. Then nothing is gained by compiling it for
    /// derivatives.
    #[doc(hidden)]
    const IS_RECORDED: bool = false;
}

impl<const D: usize, M: Metric<D>> Metric<D> for &M {
    const IS_RECORDED: bool = M::IS_RECORDED;

    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        (**self).gram(x)
    }
}

/// Returns `g_x(u, u) = uᵀ H(x) u`, in `m²`, for a vector `u` that does not depend on `x`.
#[inline]
pub fn norm_squared<S: Scalar, const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<S, D>,
    u: &SVector<f64, D>,
) -> S {
    square_of(metric.gram(x).as_slice(), u.as_slice())
}

/// Returns `uᵀ H u`, in `m²`, given the `D²` numbers of `H` column by column. It reads the upper half.
#[inline]
pub fn square_of<S: Scalar>(h: &[S], u: &[f64]) -> S {
    let d = u.len();
    let mut sum = S::zero();
    for i in 0..d {
        sum += h[i * d + i] * (u[i] * u[i]);
        for j in i + 1..d {
            sum += h[j * d + i] * (2.0 * u[i] * u[j]);
        }
    }
    sum
}

/// A metric that knows the constants of Theorem 1.1.
pub trait Bounded<const D: usize>: Metric<D> {
    /// Returns constants that hold on all of `R^D`.
    fn constants(&self) -> Constants;
}

impl<const D: usize, M: Bounded<D>> Bounded<D> for &M {
    fn constants(&self) -> Constants {
        (**self).constants()
    }
}

/// A metric with a known distance for some pairs of points, either in closed form or by a
/// quadrature that is exact to rounding.
pub trait KnownDistance<const D: usize>: Metric<D> {
    /// Returns `d^g(x, y)`, in `m`, or `None` if it is not known exactly.
    ///
    /// # Laws
    ///
    /// The distance is symmetric and zero for `x = y`; no curve from `x` to `y` is shorter.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64>;
}

impl<const D: usize, M: KnownDistance<D>> KnownDistance<D> for &M {
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        (**self).distance(x, y)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::{Bounded, KnownDistance};
    use crate::gallery::Shear;

    #[test]
    fn a_reference_to_a_metric_knows_what_the_metric_knows() {
        fn knows(metric: impl Bounded<2> + KnownDistance<2>) -> (f64, Option<f64>) {
            let distance = metric.distance(&vector![0.0, 0.0], &vector![2.0, 3.0]);
            (metric.constants().l_h(), distance)
        }
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let reference: &Shear = &shear;
        assert_eq!(knows(reference), knows(shear));
        assert!(knows(shear).1.is_some_and(|distance| distance > 1.0));
    }
}
