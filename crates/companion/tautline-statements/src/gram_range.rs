//! `GramRange`: the range of a metric over a number of points.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline::{AnyMetric, Constants, Metric, MetricError, check_gram};

use crate::{Evidence, Unit};

/// The extreme eigenvalues of `H` over a number of points, and the largest difference quotient of
/// `H` between consecutive points. The hypotheses on `c₁`, `c₂` and `L_H` are checked with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GramRange {
    /// The least eigenvalue, in `m²/ℓ²`.
    pub low: f64,
    /// The largest eigenvalue, in `m²/ℓ²`.
    pub high: f64,
    /// The largest `‖H(x) − H(y)‖ / |x − y|` of two consecutive points, in `m²/ℓ³`.
    pub slope: f64,
    /// The rounding of `slope`, in `m²/ℓ³`: `ε c/|x − y|` for the two points that attain it.
    slope_rounding: f64,
}

impl GramRange {
    /// Evaluates `H` at each of the points.
    ///
    /// # Errors
    ///
    /// [`MetricError`] where `H` is not finite, symmetric and positive definite.
    pub fn along<const D: usize>(
        metric: &impl Metric<D>,
        points: impl IntoIterator<Item = SVector<f64, D>>,
    ) -> Result<Self, MetricError> {
        Self::behind_pointers(&AnyMetric::new(metric), &mut points.into_iter())
    }

    fn behind_pointers<const D: usize>(
        metric: &AnyMetric<'_, D>,
        points: &mut dyn Iterator<Item = SVector<f64, D>>,
    ) -> Result<Self, MetricError> {
        let mut range = Self { low: f64::INFINITY, high: 0.0, slope: 0.0, slope_rounding: 0.0 };
        let mut before: Option<(SVector<f64, D>, SMatrix<f64, D, D>)> = None;
        for x in points {
            let h = check_gram(metric, &x)?;
            let (low, high) = extreme_eigenvalues(&h);
            range.low = range.low.min(low);
            range.high = range.high.max(high);
            if let Some((y, k)) = before
                && x != y
            {
                let step = (x - y).norm();
                let slope = operator_norm(&(h - k)) / step;
                if slope > range.slope {
                    range.slope = slope;
                    // An entry has a dozen roundings, and a row has D entries. The rounding of the
                    // points does not count, since H is evaluated at the rounded points.
                    range.slope_rounding = 16.0 * f64::EPSILON * D as f64 * high / step;
                }
            }
            before = Some((x, h));
        }
        Ok(range)
    }

    /// Evaluates `H` at `x` and, along each axis, at the distance `2⁻⁸ c₁/L_H` from `x`.
    ///
    /// # Errors
    ///
    /// The errors of [`along`](Self::along).
    pub fn near<const D: usize>(
        metric: &impl Metric<D>,
        constants: Constants,
        x: &SVector<f64, D>,
    ) -> Result<Self, MetricError> {
        // A constant metric has no length scale.
        let natural = constants.c1() / (256.0 * constants.l_h());
        let step = if natural.is_finite() { natural } else { x.norm().max(f64::MIN_POSITIVE) };
        let points = (0..D).flat_map(|l| {
            let mut beside = *x;
            beside[l] += step;
            [*x, beside]
        });
        Self::along(metric, points)
    }
}

impl Evidence {
    /// Adds the hypotheses of Theorem 1.1 on `c₁`, `c₂` and `L_H`. They are checked at the points
    /// where `H` was evaluated and assumed elsewhere.
    #[must_use]
    pub fn given_constants(self, constants: Constants, seen: &GramRange) -> Self {
        // An entry has a dozen roundings, and a row has D entries, where D is at most about 10.
        let rounding = 1e-14 * seen.high;
        let slopes = [seen.slope, constants.l_h()];
        self.given("c₁ ≤ λ_min(H)", Unit::GRAM, [constants.c1(), seen.low], rounding)
            .given("λ_max(H) ≤ c₂", Unit::GRAM, [seen.high, constants.c2()], rounding)
            .given("‖H(x) − H(y)‖/|x − y| ≤ L_H", Unit::GRAM_SLOPE, slopes, seen.slope_rounding)
            .assumed("c₁, c₂ and L_H hold elsewhere")
    }

    /// Adds the hypothesis on `M_H`, in `m²/ℓ⁴`. `seen` is the greatest second derivative found.
    #[must_use]
    pub fn given_curvature(self, seen: f64, m_h: f64) -> Self {
        // Where a second derivative is largest, some digits of its terms may cancel.
        let claim = "|uᵀ D²H[w, w] u| ≤ M_H";
        let seen = self.given(claim, Unit::GRAM_CURVATURE, [seen, m_h], 1e-9 * m_h);
        seen.assumed("M_H holds elsewhere")
    }
}

/// Returns the least and the largest eigenvalue of a symmetric matrix.
#[must_use]
pub fn extreme_eigenvalues<const D: usize>(matrix: &SMatrix<f64, D, D>) -> (f64, f64) {
    if D == 1 {
        return (matrix[(0, 0)], matrix[(0, 0)]);
    }
    let values =
        DMatrix::from_fn(D, D, |i, j| matrix[(i.min(j), i.max(j))]).symmetric_eigenvalues();
    (values.min(), values.max())
}

/// Returns the operator norm of a symmetric matrix.
#[must_use]
pub fn operator_norm<const D: usize>(matrix: &SMatrix<f64, D, D>) -> f64 {
    let (low, high) = extreme_eigenvalues(matrix);
    high.abs().max(low.abs())
}

#[cfg(test)]
mod tests {
    use crate::{Evidence, Statement};

    #[test]
    fn a_bound_checked_at_some_points_is_assumed_elsewhere() {
        let evidence = Evidence::of(Statement::Theorem1_1);
        let evidence = evidence.given_curvature(1.0, 2.0);
        assert_eq!((evidence.hypotheses.len(), evidence.assumed.len()), (1, 1));
        assert_eq!(evidence.assumed, ["M_H holds elsewhere"]);
    }
}
