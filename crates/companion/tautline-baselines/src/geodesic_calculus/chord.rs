//! `Chord`: the discrete energy of one chord, with its derivatives by both ends.

use nalgebra::{SMatrix, SVector};
use tautline::{Jet2, Metric, check_gram, is_gram};

use crate::{
    EquationError,
    geodesic_equation::{bend, slopes},
};

/// The derivatives of `W[x, y] = (y − x)ᵀ H((x + y)/2) (y − x)`.
pub(crate) struct Chord<const D: usize> {
    /// `∂W/∂x` and `∂W/∂y`, in `m²/ℓ`.
    pub(crate) gradients: [SVector<f64, D>; 2],
    /// `∂²W/∂x²` and `∂²W/∂y²`, in `m²/ℓ²`.
    pub(crate) own: [SMatrix<f64, D, D>; 2],
    /// `∂²W/∂x∂y`, with the rows of `x`, in `m²/ℓ²`.
    pub(crate) mixed: SMatrix<f64, D, D>,
}

impl<const D: usize> Chord<D> {
    /// Expands `W` about the chord from `x` to `y`.
    pub(crate) fn new(
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        y: &SVector<f64, D>,
    ) -> Result<Self, EquationError> {
        // Halved first: the sum of the ends may overflow.
        let (middle, d) = (x * 0.5 + y * 0.5, y - x);
        let jets = metric.gram(&SVector::from(Jet2::variables(&middle.into())));
        let h = jets.map(|jet| jet.value());
        if !is_gram(&h) {
            check_gram(metric, &middle)?;
        }
        // The columns are ∂ₘH d.
        let mut turned = SMatrix::<f64, D, D>::zeros();
        for (m, slope) in slopes(&jets).iter().enumerate() {
            turned.set_column(m, &(slope * d));
        }
        let growth = turned.tr_mul(&d);
        let second = SMatrix::<f64, D, D>::from_fn(|m, k| 0.25 * d.dot(&(bend(&jets, m, k) * d)));
        // W depends on the ends through d and, with the factor ½, through the middle:
        // ∂W/∂y = 2Hd + ½ dᵀDHd, and ∂W/∂x has the opposite sign of the part of d.
        let gradients = [growth * 0.5 - h * d * 2.0, growth * 0.5 + h * d * 2.0];
        let (even, odd) = (turned + turned.transpose(), turned - turned.transpose());
        let own = [h * 2.0 - even + second, h * 2.0 + even + second];
        // ∂/∂y of ½ dᵀDHd − 2Hd.
        let mixed = second - odd - h * 2.0;
        let sum = gradients[1].sum() + own[0].sum() + own[1].sum() + mixed.sum();
        if !sum.is_finite() {
            return Err(EquationError::Derivative { point: middle.iter().copied().collect() });
        }
        Ok(Self { gradients, own, mixed })
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline::gallery::Swirl;
    use tautline::{PointSequence, Rule, energy_gradient};

    use super::Chord;

    /// For `N = 1` the discrete energy is `W`. Both sum a few dozen products of numbers below 10.
    #[test]
    fn the_gradients_are_those_of_the_discrete_energy() {
        let swirl = Swirl::new(1.5, 0.8).expect("a width");
        let (x, y) = (vector![0.7, -0.3], vector![0.2, 0.4]);
        let line = PointSequence::new(vec![x, y]).expect("finite");
        let (_, expected) = energy_gradient(Rule::TRAPEZOIDAL, &swirl, &line);
        let found = Chord::new(&swirl, &x, &y).expect("smooth").gradients;
        for end in 0..2 {
            assert!((found[end] - expected[end]).norm() < 1e-13, "{}", found[end]);
            assert!(expected[end].norm() > 0.1);
        }
    }

    /// A central difference of step `h = 10⁻⁴` has the error `h²/6` times a derivative below `10³`.
    #[test]
    fn the_second_derivatives_are_those_of_differences() {
        let swirl = Swirl::new(1.5, 0.8).expect("a width");
        let (x, y) = (vector![0.7, -0.3], vector![0.2, 0.4]);
        let at = |x, y| Chord::new(&swirl, &x, &y).expect("smooth");
        let exact = at(x, y);
        for m in 0..2 {
            let step = SVector::<f64, 2>::from_fn(|i, _| if i == m { 1e-4 } else { 0.0 });
            let (xs, ys) = ([at(x - step, y), at(x + step, y)], [at(x, y - step), at(x, y + step)]);
            let slope = |pair: &[Chord<2>; 2], end: usize| {
                (pair[1].gradients[end] - pair[0].gradients[end]) / 2e-4
            };
            assert!((exact.own[0].column(m) - slope(&xs, 0)).norm() < 2e-6);
            assert!((exact.own[1].column(m) - slope(&ys, 1)).norm() < 2e-6);
            assert!((exact.mixed.column(m) - slope(&ys, 0)).norm() < 2e-6);
            assert!((exact.mixed.transpose().column(m) - slope(&xs, 1)).norm() < 2e-6);
            assert!(slope(&ys, 0).norm() > 0.1 && slope(&xs, 0).norm() > 0.1);
        }
    }
}
