//! The geodesic equation, with its derivatives, from second-order jets of the metric's formula.

use nalgebra::{Cholesky, SMatrix, SVector};
use tautline::{Jet2, Metric, MetricError, check_gram, is_gram};

/// The reason why the geodesic equation makes no sense at a point.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EquationError {
    /// `H` is not finite, symmetric and positive definite.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// `H` is a Gram matrix, but the acceleration or a derivative of it is NaN or infinite.
    #[error("at {point:?} the metric has no finite derivatives up to second order")]
    Derivative {
        /// The point.
        point: Vec<f64>,
    },
}

/// The acceleration of a geodesic at a point, in `ℓ`, and its derivatives, which are pure numbers.
///
/// The Euler–Lagrange equation of `∫ γ̇ᵀ H(γ) γ̇ dt` is
///
/// ```text
/// γ̈ = −H⁻¹ q(γ, γ̇),    q(x, v) = DH[v] v − ½ ∇ₓ(vᵀHv)
/// ```
pub(crate) struct Acceleration<const D: usize> {
    /// `a(x, v) = −H⁻¹ q`.
    pub(crate) value: SVector<f64, D>,
    /// `∂a/∂x`.
    pub(crate) by_position: SMatrix<f64, D, D>,
    /// `∂a/∂v`.
    pub(crate) by_velocity: SMatrix<f64, D, D>,
}

impl<const D: usize> Acceleration<D> {
    /// Evaluates the equation at the point `x` for the velocity `v`.
    pub(crate) fn new(
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        v: &SVector<f64, D>,
    ) -> Result<Self, EquationError> {
        let jets = metric.gram(&SVector::from(Jet2::variables(&(*x).into())));
        let factor = factor(metric, x, &jets.map(|jet| jet.value()))?;
        let slopes = slopes(&jets);
        // The columns are ∂ₘH v.
        let mut turned = SMatrix::<f64, D, D>::zeros();
        let mut along = SMatrix::<f64, D, D>::zeros();
        for m in 0..D {
            turned.set_column(m, &(slopes[m] * v));
            along += slopes[m] * v[m];
        }
        // DH[v] v = Σ vₘ ∂ₘH v, and (∇ₓ vᵀHv)ₘ = vᵀ ∂ₘH v.
        let value = -factor.solve(&(turned * v - turned.tr_mul(v) * 0.5));
        let by_velocity = -factor.solve(&(along + turned - turned.transpose()));
        let mut bent = SMatrix::<f64, D, D>::zeros();
        for m in 0..D {
            // The columns are ∂ₘ∂ₖH v; H a = −q gives H ∂ₘa = −∂ₘq − ∂ₘH a.
            let mut second = SMatrix::<f64, D, D>::zeros();
            for k in 0..D {
                second.set_column(k, &(bend(&jets, m, k) * v));
            }
            let change = second * v - second.tr_mul(v) * 0.5 + slopes[m] * value;
            bent.set_column(m, &change);
        }
        let by_position = -factor.solve(&bent);
        let sum = value.sum() + by_position.sum() + by_velocity.sum();
        if !sum.is_finite() {
            return Err(EquationError::Derivative { point: x.iter().copied().collect() });
        }
        Ok(Self { value, by_position, by_velocity })
    }
}

/// Returns the factor of `h = H(x)`, or the reason why it is no Gram matrix.
fn factor<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    h: &SMatrix<f64, D, D>,
) -> Result<Cholesky<f64, nalgebra::Const<D>>, EquationError> {
    if !is_gram(h) {
        check_gram(metric, x)?;
    }
    Cholesky::new(*h)
        .ok_or_else(|| EquationError::Derivative { point: x.iter().copied().collect() })
}

/// Returns whether an energy, in `m²`, is a number with all its digits, or zero for a curve that
/// rests.
pub(crate) fn in_range(energy: f64, rests: bool) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&energy) || (rests && energy == 0.0)
}

/// Returns the matrices `∂ₘH`, read from the half `i ≤ j`.
pub(crate) fn slopes<const D: usize>(
    jets: &SMatrix<Jet2<f64, D>, D, D>,
) -> [SMatrix<f64, D, D>; D] {
    std::array::from_fn(|m| SMatrix::from_fn(|i, j| jets[(i.min(j), i.max(j))].first(m)))
}

/// Returns the matrix `∂ₘ∂ₖH`, read from the half `i ≤ j`.
pub(crate) fn bend<const D: usize>(
    jets: &SMatrix<Jet2<f64, D>, D, D>,
    m: usize,
    k: usize,
) -> SMatrix<f64, D, D> {
    SMatrix::from_fn(|i, j| jets[(i.min(j), i.max(j))].second(m, k))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline::gallery::{HyperbolicPatch, Swirl};
    use tautline::{Metric, Scalar, christoffel};

    use super::{Acceleration, EquationError};

    /// Both are sums of a few dozen products of numbers below 10.
    const ROUNDING: f64 = 1e-12;

    #[test]
    fn the_acceleration_is_that_of_the_christoffel_symbols() {
        let swirl = Swirl::new(1.5, 0.8).expect("a width");
        let (x, v) = (vector![0.7, -0.3], vector![1.2, 0.4]);
        let gamma = christoffel(&swirl, &x).expect("positive definite");
        let expected = SVector::<f64, 2>::from_fn(|k, _| -v.dot(&(gamma[k] * v)));
        let found = Acceleration::new(&swirl, &x, &v).expect("smooth").value;
        assert!((found - expected).norm() < ROUNDING && expected.norm() > 0.1);
    }

    /// A central difference of step `h` has the error `h² |a‴|/6` and the rounding `ε |a|/h`. With
    /// `h = 10⁻⁴`, `|a‴| < 10³` and `|a| < 10²` the sum is below `2 · 10⁻⁶`.
    #[test]
    fn the_derivatives_are_those_of_differences() {
        fn compare(metric: &impl Metric<2>) {
            let (x, v) = (vector![0.3, -0.2], vector![1.2, 0.4]);
            let at = |x, v| Acceleration::new(metric, &x, &v).expect("smooth");
            let exact = at(x, v);
            for m in 0..2 {
                let step = SVector::<f64, 2>::from_fn(|i, _| if i == m { 1e-4 } else { 0.0 });
                let by_position = (at(x + step, v).value - at(x - step, v).value) / 2e-4;
                let by_velocity = (at(x, v + step).value - at(x, v - step).value) / 2e-4;
                assert!((exact.by_position.column(m) - by_position).norm() < 2e-6);
                assert!((exact.by_velocity.column(m) - by_velocity).norm() < 2e-6);
                assert!(by_position.norm() > 0.1 && by_velocity.norm() > 0.1);
            }
        }
        compare(&Swirl::new(1.5, 0.8).expect("a width"));
        compare(&HyperbolicPatch::new(0.6).expect("a radius"));
    }

    #[test]
    fn a_metric_without_derivatives_is_an_error() {
        struct Edge;
        impl Metric<1> for Edge {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                SMatrix::from_diagonal_element(x[0].sqrt() + 1.0)
            }
        }
        let at = |x: f64| Acceleration::new(&Edge, &vector![x], &vector![1.0]).err();
        assert_eq!(at(0.0), Some(EquationError::Derivative { point: vec![0.0] }));
        assert!(matches!(at(-1.0), Some(EquationError::Metric(_))));
        assert_eq!(at(1.0), None);
    }
}
