//! `Interpolation`: the curve `γᵖˡ` that joins a point sequence by straight lines.

use nalgebra::SVector;
use tautline_metrics::{
    Metric,
    quadrature::{Integral, integrate},
};

use crate::{PointSequence, compensated_sum::CompensatedSum};

/// Relative tolerance of the quadrature on each chord: a few roundings, so that the error of
/// `E(γᵖˡ) − d²` stays that of `d²` itself.
const TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// The linear interpolation `γᵖˡ` of a point sequence: the reconstructed curve.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "reconstruction")]
pub struct Interpolation<'a, const D: usize> {
    sequence: &'a PointSequence<D>,
}

impl<'a, const D: usize> Interpolation<'a, D> {
    /// Joins the points of `sequence`.
    #[must_use]
    pub fn new(sequence: &'a PointSequence<D>) -> Self {
        Self { sequence }
    }

    /// Returns `γᵖˡ(t)`, in `ℓ`; `t` is cut to `[0, 1]`.
    #[must_use]
    pub fn at(&self, t: f64) -> SVector<f64, D> {
        let points = self.sequence.points();
        let position = t.clamp(0.0, 1.0) * (points.len() - 1) as f64;
        // The last chord takes t = 1.
        let k = (position as usize).min(points.len() - 2);
        let s = position - k as f64;
        points[k] * (1.0 - s) + points[k + 1] * s
    }

    /// Returns the continuous energy `E(γᵖˡ) = ∫₀¹ γ̇ᵀ H(γ) γ̇ dt`, in `m²`.
    ///
    /// By adaptive Gauss–Kronrod quadrature on each chord to some units of rounding; the
    /// error that is returned is an estimate. NaN where the metric is.
    #[must_use]
    pub fn energy(&self, metric: &impl Metric<D>) -> Integral {
        let sum = self.quadrature(|x, d| metric.norm_squared(x, d));
        let n = self.sequence.n().get() as f64;
        Integral { value: n * sum.value, error: n * sum.error }
    }

    /// Returns the length `L(γᵖˡ) = ∫₀¹ (γ̇ᵀ H(γ) γ̇)^{1/2} dt`, in `m`; error as for the energy.
    #[must_use]
    pub fn length(&self, metric: &impl Metric<D>) -> Integral {
        self.quadrature(|x, d| metric.norm_squared(x, d).sqrt())
    }

    /// `Σ ∫₀¹ f(x + s d, d) ds` over the chords.
    fn quadrature(&self, f: impl Fn(&SVector<f64, D>, &SVector<f64, D>) -> f64) -> Integral {
        let (mut value, mut error) = (CompensatedSum::default(), 0.0);
        for (x, d) in self.sequence.chords() {
            let part = integrate(|s| f(&(x + d * s), &d), 0.0, 1.0, TOLERANCE);
            value.add(part.value);
            error += part.error;
        }
        Integral { value: value.value(), error }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::vector;
    use tautline_metrics::gallery::Valleys;

    use super::Interpolation;
    use crate::PointSequence;

    /// Along `x₁` the valleys have `∫ f² = (9/2) x − 4 sin x + ¼ sin 2x` and `∫ f = 2x − sin x`.
    #[test]
    fn energy_and_length_agree_with_the_primitives() {
        let sequence =
            PointSequence::new(vec![vector![0.0, 1.0], vector![1.5, 1.0], vector![7.0, 1.0]])
                .expect("finite");
        let f2 = |x: f64| 4.5 * x - 4.0 * x.sin() + 0.25 * (2.0 * x).sin();
        let f1 = |x: f64| 2.0 * x - x.sin();
        // On a chord of length d traversed in time 1/2: ∫ f² (2d)² dt = 2 d ∫ f² dx.
        let energy = 2.0 * (1.5 * f2(1.5) + 5.5 * (f2(7.0) - f2(1.5)));
        let curve = Interpolation::new(&sequence);
        let computed = curve.energy(&Valleys);
        assert_relative_eq!(computed.value, energy, max_relative = 1e-14);
        // Some roundings of the value, and no less than one.
        let relative = computed.error / energy;
        assert!((f64::EPSILON..=1e-13).contains(&relative), "estimate {relative:e}");
        assert_relative_eq!(curve.length(&Valleys).value, f1(7.0), max_relative = 1e-14);
    }

    #[test]
    fn the_curve_passes_through_its_points() {
        let sequence =
            PointSequence::new(vec![vector![0.0], vector![1.0], vector![5.0]]).expect("finite");
        let curve = Interpolation::new(&sequence);
        let values = [-1.0, 0.0, 0.25, 0.5, 0.75, 1.0, 2.0].map(|t| curve.at(t)[0]);
        assert_eq!(values, [0.0, 0.0, 0.5, 1.0, 3.0, 5.0, 5.0]);
        let squares = (0..6).map(|k| vector![f64::from(k * k)]).collect();
        let squares = PointSequence::new(squares).expect("finite");
        let curve = Interpolation::new(&squares);
        assert_eq!([0.1, 0.9, 1.0].map(|t| curve.at(t)[0]), [0.5, 20.5, 25.0]);
    }
}
