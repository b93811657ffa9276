//! The discrete energy for argmin: its value, its gradient, and its Hessian as a product with
//! vectors.

use std::sync::Arc;

use argmin::core::{CostFunction, Error, Gradient, Hessian};
use argmin_math::ArgminDot;
use tautline::{Jet2, Metric, PointSequence, Rule, SMatrix, SVector, energy_gradient};

/// The discrete energy as a function of the inner points. Both ends are fixed.
pub(crate) struct DiscreteEnergy<M, const D: usize> {
    pub(crate) metric: M,
    pub(crate) start: PointSequence<D>,
}

impl<M: Metric<D>, const D: usize> DiscreteEnergy<M, D> {
    pub(crate) fn sequence(&self, inner: &[f64]) -> Result<PointSequence<D>, Error> {
        let inner = inner.chunks_exact(D).map(SVector::from_column_slice);
        let ends = (*self.start.first(), *self.start.last());
        Ok(PointSequence::new([ends.0].into_iter().chain(inner).chain([ends.1]).collect())?)
    }
}

impl<M: Metric<D>, const D: usize> CostFunction for DiscreteEnergy<M, D> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, inner: &Vec<f64>) -> Result<f64, Error> {
        Ok(Rule::TRAPEZOIDAL.energy(&self.metric, &self.sequence(inner)?))
    }
}

impl<M: Metric<D>, const D: usize> Gradient for DiscreteEnergy<M, D> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, inner: &Vec<f64>) -> Result<Vec<f64>, Error> {
        let (_, all) = energy_gradient(Rule::TRAPEZOIDAL, &self.metric, &self.sequence(inner)?);
        Ok(all[1..all.len() - 1].iter().flatten().copied().collect())
    }
}

/// The second derivatives of the energy of one chord with respect to its first and its last point.
#[derive(Clone, Debug)]
struct ChordHessian<const D: usize> {
    first: SMatrix<f64, D, D>,
    /// The mixed derivatives: rows belong to the first point, columns to the last.
    mixed: SMatrix<f64, D, D>,
    last: SMatrix<f64, D, D>,
}

/// The Hessian as a product with vectors. It is cheap to clone, which argmin does in each step.
#[derive(Clone, Debug)]
pub(crate) struct ChordHessians<const D: usize>(Arc<Vec<ChordHessian<D>>>);

impl<M: Metric<D>, const D: usize> Hessian for DiscreteEnergy<M, D> {
    type Param = Vec<f64>;
    type Hessian = ChordHessians<D>;

    /// The energy of a chord from `a` to `b` is `e = βᵀ H(x) β / N`, where `x` is its middle and
    /// `β = N (b − a)`. With `A = 2 N H`, `B_ik = (∂ₖH β)ᵢ` and `C_kl = βᵀ ∂ₖ∂ₗH β / 4N`, we have
    ///
    /// ```text
    /// ∂²e/∂b∂b = A + B + Bᵀ + C,   ∂²e/∂a∂a = A − B − Bᵀ + C,   ∂²e/∂a∂b = −A − B + Bᵀ + C.
    /// ```
    fn hessian(&self, inner: &Vec<f64>) -> Result<ChordHessians<D>, Error> {
        let sequence = self.sequence(inner)?;
        let n = sequence.n().get() as f64;
        let chord = |points: &[SVector<f64, D>]| {
            let beta = (points[1] - points[0]) * n;
            let middle = (points[0] + points[1]) * 0.5;
            let jets = self.metric.gram(&SVector::from(Jet2::variables(&middle.into())));
            let a = SMatrix::from_fn(|i, j| 2.0 * n * jets[(i, j)].value());
            let b = SMatrix::<f64, D, D>::from_fn(|i, k| {
                (0..D).map(|j| jets[(i, j)].first(k) * beta[j]).sum()
            });
            let c = SMatrix::<f64, D, D>::from_fn(|k, l| {
                let along =
                    |i: usize| (0..D).map(|j| jets[(i, j)].second(k, l) * beta[j]).sum::<f64>();
                (0..D).map(|i| beta[i] * along(i)).sum::<f64>() / (4.0 * n)
            });
            let symmetric = b + b.transpose();
            ChordHessian {
                first: a - symmetric + c,
                mixed: -a - b + b.transpose() + c,
                last: a + symmetric + c,
            }
        };
        Ok(ChordHessians(Arc::new(sequence.points().windows(2).map(chord).collect())))
    }
}

impl<const D: usize> ArgminDot<Vec<f64>, Vec<f64>> for ChordHessians<D> {
    fn dot(&self, inner: &Vec<f64>) -> Vec<f64> {
        let mut product = vec![0.0; inner.len()];
        let at = |k: usize| SVector::<f64, D>::from_column_slice(&inner[k * D..][..D]);
        let mut add = |k: usize, part: SVector<f64, D>| {
            let entries = product[k * D..][..D].iter_mut();
            entries.zip(&part).for_each(|(entry, part)| *entry += part);
        };
        // Inner point k is the last point of chord k and the first point of chord k + 1.
        for (k, pair) in self.0.windows(2).enumerate() {
            add(k, (pair[0].last + pair[1].first) * at(k));
            if (k + 1) * D < inner.len() {
                add(k, pair[1].mixed * at(k + 1));
                add(k + 1, pair[1].mixed.transpose() * at(k));
            }
        }
        product
    }
}
